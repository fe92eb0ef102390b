// osem leaves: every leaf of an octree file, one a line.
#include <charconv>
#include <cstring>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"

namespace osem::host {

namespace {

// Lines gather in one buffer: a tree may have many millions of leaves.
class LeafLines {
  public:
    explicit LeafLines(std::ostream& out) : out_(out), buffer_(std::size_t{1} << 16) {}

    /// False once the stream refuses.
    bool add(const Leaf& leaf) {
        if (buffer_.size() - used_ < longest_line && !flush()) return false;
        for (const std::int32_t coordinate : leaf.octant.corner.at) number(coordinate);
        number(leaf.octant.side());
        word(leaf.colour == Colour::white   ? "white\n"
             : leaf.colour == Colour::black ? "black\n"
                                            : "boundary\n");
        return true;
    }

    bool flush() {
        out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
        used_ = 0;
        return out_.good();
    }

  private:
    static constexpr std::size_t longest_line = 64; // four numbers of up to 7 digits, blanks and a word

    void number(std::int32_t value) {
        char* const at = buffer_.data() + used_;
        char* const end = std::to_chars(at, at + longest_line, value).ptr;
        *end = ' ';
        used_ += static_cast<std::size_t>(end - at) + 1;
    }
    void word(const char* text) {
        const std::size_t length = std::strlen(text);
        std::memcpy(buffer_.data() + used_, text, length);
        used_ += length;
    }

    std::ostream& out_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
};

void run_leaves(const std::string& input, std::ostream& out) {
    TreeFile file(input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    LeafLines lines(out);
    LeafWalk walk(tree);
    Leaf leaf = {};
    bool taken = true;
    while (taken && walk.next(leaf)) taken = lines.add(leaf);
    lines.flush(); // a stream that refuses is reported once, when the command has ended
}

constexpr const char* footer =
    "One line a leaf, in Morton order (x varies fastest): \"x y z side colour\". The corner and the side "
    "are\n"
    "in lattice units, 2^20 of which make the root's side; the colour is white, black or boundary.";

} // namespace

void add_leaves(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("leaves", "Print every leaf of an octree");
    const auto input = std::make_shared<std::string>();
    command->add_option("X", *input, "Octree file")->required()->type_name("");
    command->footer(footer);
    command->callback([input, &console] { run_leaves(*input, console.out); });
}

} // namespace osem::host
