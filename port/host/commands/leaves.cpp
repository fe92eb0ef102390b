// osem leaves: every leaf of an octree file, one a line.
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "console/text_lines.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"

namespace osem::host {

namespace {

// False once the stream refuses.
bool add_leaf(TextLines& lines, const Leaf& leaf) {
    if (!lines.start_line()) return false;
    for (const std::int32_t coordinate : leaf.octant.corner.at) lines.number(coordinate);
    lines.number(leaf.octant.side());
    lines.word(leaf.colour == Colour::white   ? "white\n"
               : leaf.colour == Colour::black ? "black\n"
                                              : "boundary\n");
    return true;
}

void run_leaves(const std::string& input, std::ostream& out) {
    TreeFile file(input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    TextLines lines(out);
    LeafWalk walk(tree);
    Leaf leaf = {};
    bool taken = true;
    while (taken && walk.next(leaf)) taken = add_leaf(lines, leaf);
    lines.flush(); // a stream that refuses is reported once, when the command has ended
}

constexpr const char* leaves_footer =
    "One line a leaf, in Morton order (x varies fastest): \"x y z side colour\". The corner and the side "
    "are\n"
    "in lattice units, 2^20 of which make the root's side; the colour is white, black or boundary.";

} // namespace

void add_leaves(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("leaves", "Print every leaf of an octree");
    const auto input = std::make_shared<std::string>();
    command->add_option("X", *input, "Octree file")->required()->type_name("");
    command->footer(leaves_footer);
    command->callback([input, &console] { run_leaves(*input, console.out); });
}

} // namespace osem::host
