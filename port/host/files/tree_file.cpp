#include "files/tree_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <vector>

#include "files/decimal.hpp"
#include "files/output_file.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8, "frames are binary64 numbers");

std::uint64_t bits_of(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

double from_bits(std::uint64_t bits) {
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

WorldCube cube_of(const StreamHeader& header) {
    return {{from_bits(header.frame[0]), from_bits(header.frame[1]), from_bits(header.frame[2])},
            from_bits(header.frame[3])};
}

bool write_bytes(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& stream = *static_cast<std::ostream*>(context);
    stream.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    return stream.good();
}

bool replace_bytes(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& stream = *static_cast<std::ostream*>(context);
    stream.seekp(0);
    return write_bytes(context, bytes, count) && stream.seekp(0, std::ios::end).good();
}

} // namespace

void TreeFile::damaged(const char* what, std::uint64_t offset) const {
    throw BadInput(path_ + ": " + what + " at byte " + std::to_string(offset));
}

TreeFile::TreeFile(const std::string& path) : path_(path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw BadInput(path + ": cannot be opened: " + std::generic_category().message(ENOENT));
    }
    if (!std::filesystem::is_regular_file(status)) throw BadInput(path + ": is not a regular file");
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (!error) stream_.open(path, std::ios::binary);
    if (error || !stream_) throw BadInput(path + ": cannot be read");
    read_header(size);
}

void TreeFile::read_header(std::uint64_t size) {
    std::uint8_t bytes[stream_header_size];
    stream_.read(reinterpret_cast<char*>(bytes), sizeof bytes);
    StreamReader reader;
    reader.begin(nullptr);
    const Status status = reader.feed(bytes, static_cast<std::size_t>(stream_.gcount()));
    if (status != Status::ok || !reader.has_header()) {
        const StreamOutcome outcome = reader.finish();
        damaged(describe(outcome.built.status), outcome.offset);
    }
    const StreamHeader& header = reader.header();
    const std::uint64_t expected = stream_size(header.nodes);
    if (size < expected) damaged(describe(Status::stream_truncated), size);
    if (size > expected) damaged(describe(Status::stream_trailing_bytes), expected);
    facts_ = {cube_of(header), static_cast<LeafRule>(header.leaf_rule)};
    if (!is_cube(facts_.cube)) damaged("the frame is not a cube of finite numbers", 8);
    nodes_ = header.nodes;
    depth_ = header.depth;
}

void TreeFile::refuse(Status status, std::uint64_t offset) const {
    if (status == Status::source_failed) throw BadInput(path_ + ": cannot be read");
    damaged(describe(status), offset);
}

bool TreeFile::read_at(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count) {
    std::ifstream& stream = static_cast<TreeFile*>(context)->stream_;
    if (static_cast<std::uint64_t>(stream.tellg()) != offset) {
        stream.seekg(static_cast<std::streamoff>(offset));
    }
    stream.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count));
    return stream.good();
}

Source TreeFile::source() {
    stream_.clear();
    return Source{read_at, this, stream_size(nodes_)};
}

Octree TreeFile::read(NodePool& pool) {
    std::vector<char> chunk(std::size_t{1} << 16);
    stream_.clear();
    stream_.seekg(0);
    StreamReader reader;
    reader.begin(&pool);
    Status status = Status::ok;
    while (status == Status::ok && stream_) {
        stream_.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
        status = reader.feed(reinterpret_cast<const std::uint8_t*>(chunk.data()),
                             static_cast<std::size_t>(stream_.gcount()));
    }
    if (stream_.bad()) throw BadInput(path_ + ": cannot be read");
    const StreamOutcome outcome = reader.finish();
    if (outcome.built.status != Status::ok) damaged(describe(outcome.built.status), outcome.offset);
    return outcome.built.tree;
}

void write_tree(OutputFile& file, const Octree& tree, const TreeFacts& facts) {
    StreamHeader header = {};
    header.leaf_rule = static_cast<std::uint8_t>(facts.leaves);
    for (std::size_t i = 0; i < 3; ++i) header.frame[i] = bits_of(facts.cube.origin[i]);
    header.frame[3] = bits_of(facts.cube.side);
    if (write_stream(tree, header, sink_of(file)) == Status::stream_count_mismatch) {
        throw BadInput("the tree has too many nodes for a file");
    } // and commit() reports a refusal
}

Sink sink_of(OutputFile& file) {
    return Sink{write_bytes, &file.stream(), file.is_regular() ? replace_bytes : nullptr};
}

bool is_tree_name(const std::string& path) {
    return equal_ignoring_case(std::filesystem::path(path).extension().string(), ".osem");
}

const char* leaf_rule_name(LeafRule rule) { return rule == LeafRule::centre ? "centre" : "conservative"; }

bool same_cube(const WorldCube& a, const WorldCube& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (bits_of(a.origin[i]) != bits_of(b.origin[i])) return false;
    }
    return bits_of(a.side) == bits_of(b.side);
}

} // namespace osem::host
