// The tool's readers: mesh files in four formats, .osem files, expressions, frames, budgets, names. Refusals
// are BadInput and nothing else, memory is in proportion to the file, and what is accepted is the same after
// it has been written and read once more.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "commands/expression.hpp"
#include "files/decimal.hpp"
#include "files/identifier.hpp"
#include "files/node_budget.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/quantize.hpp"
#include "mesh/readers.hpp"
#include "mesh/write_off.hpp"
#include "osem/stream_query.hpp"
#include "support/byte_stream.hpp"
#include "support/heap_pool.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

using host::Mesh;

enum class Format : std::uint8_t { off, stl, obj, poly };

Mesh read_as(Format format, std::string_view text) {
    switch (format) {
    case Format::off:
        return host::read_off(text);
    case Format::stl:
        return host::read_stl(text);
    case Format::obj:
        return host::read_obj(text);
    case Format::poly:
        break;
    }
    return host::read_poly(text);
}

std::string point_text(const std::array<double, 3>& p) {
    return host::decimal(p[0]) + ' ' + host::decimal(p[1]) + ' ' + host::decimal(p[2]) + '\n';
}

std::string ring_text(const Mesh& mesh, std::uint32_t ring, std::uint32_t first) {
    std::string text;
    for (std::uint32_t i = mesh.ring_starts[ring]; i < mesh.ring_starts[ring + 1]; ++i) {
        text += ' ' + std::to_string(mesh.corners[i] + first);
    }
    return text + '\n';
}

std::uint32_t ring_length(const Mesh& mesh, std::uint32_t ring) {
    return mesh.ring_starts[ring + 1] - mesh.ring_starts[ring];
}

std::string facet_text(const Mesh& mesh, std::uint32_t face) {
    std::string text = "facet normal 0 0 0\nouter loop\n";
    for (std::uint32_t i = 3 * face; i < 3 * face + 3; ++i)
        text += "vertex " + point_text(mesh.vertices[mesh.corners[i]]);
    return text + "endloop\nendfacet\n";
}

/// The mesh in the plainest form of its format.
std::string written_as(Format format, const Mesh& mesh) {
    std::string text;
    if (format == Format::off) {
        text =
            "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.face_count()) + " 0\n";
    }
    if (format == Format::poly) text = std::to_string(mesh.vertices.size()) + " 3 0 0\n";
    for (std::size_t v = 0; v < mesh.vertices.size() && format != Format::stl; ++v) {
        if (format == Format::obj) text += "v ";
        if (format == Format::poly) text += std::to_string(v) + ' ';
        text += point_text(mesh.vertices[v]);
    }
    if (format == Format::stl) text += "solid\n";
    if (format == Format::poly) text += std::to_string(mesh.face_count()) + " 0\n";
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
        if (format == Format::stl) {
            text += facet_text(mesh, face);
            continue;
        }
        if (format == Format::poly)
            text += std::to_string(mesh.face_rings[face + 1] - mesh.face_rings[face]) + '\n';
        for (std::uint32_t ring = mesh.face_rings[face]; ring < mesh.face_rings[face + 1]; ++ring) {
            text += format == Format::obj ? "f" : std::to_string(ring_length(mesh, ring));
            text += ring_text(mesh, ring, format == Format::obj ? 1 : 0);
        }
    }
    if (format == Format::stl) text += "endsolid\n";
    if (format == Format::poly) text += "0\n";
    return text;
}

void expect_sound(const Mesh& mesh, std::size_t file_size) {
    for (const auto& vertex : mesh.vertices) {
        for (const double at : vertex) EXPECT_TRUE(std::isfinite(at));
    }
    for (const std::uint32_t corner : mesh.corners) EXPECT_LT(corner, mesh.vertices.size());
    ASSERT_EQ(mesh.face_rings.back() + 1, mesh.ring_starts.size());
    ASSERT_EQ(mesh.ring_starts.back(), mesh.corners.size());
    for (std::uint32_t ring = 0; ring < mesh.ring_count(); ++ring) EXPECT_GE(ring_length(mesh, ring), 3U);
    const std::size_t memory = 24 * mesh.vertices.capacity() + 4 * mesh.corners.capacity() +
                               4 * mesh.ring_starts.capacity() + 4 * mesh.face_rings.capacity();
    EXPECT_LE(memory, 16 * file_size + 1024);
}

bool same(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.corners == b.corners && a.ring_starts == b.ring_starts &&
           a.face_rings == b.face_rings && a.oriented == b.oriented;
}

/// The rings by the places of their corners.
std::vector<std::vector<std::array<std::int32_t, 3>>> rings_of(const host::IntegerSolid& solid) {
    std::vector<std::vector<std::array<std::int32_t, 3>>> rings;
    for (std::uint32_t ring = 0; ring < solid.ring_count(); ++ring) {
        rings.emplace_back();
        for (std::uint32_t i = solid.ring_starts[ring]; i < solid.ring_starts[ring + 1]; ++i) {
            const Point& p = solid.vertices[solid.corners[i]];
            rings.back().push_back({p.x(), p.y(), p.z()});
        }
    }
    return rings;
}

/// On the lattice: a solid that the kernel takes comes back from a file of it, ring for ring.
void put_on_lattice(const Mesh& mesh) {
    const host::IntegerSolid solid = host::quantize(mesh, host::default_cube(mesh));
    static_cast<void>(host::check_or_throw(solid));
    std::ostringstream file;
    host::write_off(file, solid);
    host::IntegerSolid back;
    EXPECT_NO_THROW({
        back = host::quantize(host::read_off(file.str()), {{0, 0, 0}, static_cast<double>(root_side)});
        static_cast<void>(host::check_or_throw(back));
    }) << file.str();
    if (solid.ring_count() == solid.face_count()) {
        EXPECT_TRUE(rings_of(solid) == rings_of(back)) << file.str();
    }
}

void test_mesh(Format format, const std::vector<std::uint8_t>& bytes) {
    const std::string text(bytes.begin(), bytes.end());
    Mesh mesh;
    try {
        mesh = read_as(format, text);
    } catch (const host::BadInput& fault) {
        EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
        return;
    }
    expect_sound(mesh, text.size());
    const bool can_be_empty = format != Format::poly || !mesh.vertices.empty();
    if (can_be_empty) {
        EXPECT_TRUE(same(read_as(format, written_as(format, mesh)), mesh)) << written_as(format, mesh);
    }
    try {
        put_on_lattice(mesh);
    } catch (const host::BadInput&) { // a mesh that is no solid
    }
}

/// Bytes as a file, which exists as long as this.
class MemoryFile {
  public:
    explicit MemoryFile(const std::vector<std::uint8_t>& bytes) : descriptor_(memfd_create("input", 0)) {
        EXPECT_GE(descriptor_, 0);
        EXPECT_EQ(write(descriptor_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

void repair(std::vector<std::uint8_t>& bytes) {
    const auto put = [&](std::size_t first, std::size_t count, std::size_t at) {
        const std::uint32_t crc = tests::plain_crc(bytes.data() + first, count);
        for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    };
    if (bytes.size() >= stream_header_size) put(0, 44, 44);
    if (bytes.size() >= stream_header_size + 5) put(48, bytes.size() - 52, bytes.size() - 4);
}

/// A file is taken exactly if the kernel's reader takes its bytes and the frame is a cube.
void test_tree(std::vector<std::uint8_t> bytes, bool repaired) {
    if (repaired) repair(bytes);
    StreamReader reader;
    const StreamOutcome plain = tests::read_stream(reader, bytes, nullptr);
    const MemoryFile file(bytes);
    bool taken = false;
    try {
        host::TreeFile tree_file(file.path());
        EXPECT_LE(stream_size(tree_file.nodes()), bytes.size());
        tests::HeapPool pool(tree_file.nodes());
        const Octree tree = tree_file.read(*pool);
        taken = true;
        StreamHeader header = reader.header();
        EXPECT_TRUE(tests::written(tree, header) == bytes);
        EXPECT_TRUE(host::is_cube(tree_file.facts().cube));
        EXPECT_EQ(tree_file.depth(), tree.depth);
        EXPECT_TRUE(host::same_cube(tree_file.facts().cube, tree_file.facts().cube));
        EXPECT_TRUE(same_leaves(tree_file.source(), tree).same);
    } catch (const host::BadInput& fault) {
        EXPECT_FALSE(taken) << fault.what();
    }
    if (plain.built.status != Status::ok) {
        EXPECT_FALSE(taken);
    }
    if (plain.built.status != Status::ok || taken) return;
    double frame[4] = {};
    std::memcpy(frame, reader.header().frame, sizeof frame);
    EXPECT_FALSE(host::is_cube({{frame[0], frame[1], frame[2]}, frame[3]})) << "a good file is refused";
}

/// The same expression with a parenthesis for each operator.
std::string infix(const std::vector<CsgToken>& tokens, const std::vector<std::string>& names) {
    constexpr char signs[] = {'|', '&', '-', '^'};
    std::vector<std::string> values;
    for (const CsgToken& token : tokens) {
        if (token.kind == CsgTokenKind::operand) {
            values.push_back(names.at(token.operand));
            continue;
        }
        std::string b = values.back();
        if (token.kind == CsgTokenKind::complement) {
            values.back() = "!" + b;
            continue;
        }
        values.pop_back();
        values.back() = "(" + values.back() + signs[static_cast<unsigned>(token.op)] + b + ")";
    }
    return values.at(0);
}

void test_expression(const std::string& text) {
    const std::vector<std::string> names = {"a", "b"};
    std::vector<CsgToken> tokens;
    try {
        tokens = host::parse_expression(text, names);
    } catch (const host::ExpressionFault&) {
        return;
    }
    const std::string plain = infix(tokens, names);
    std::vector<CsgToken> again;
    try {
        again = host::parse_expression(plain, names);
    } catch (const host::ExpressionFault&) {
        EXPECT_GT(tokens.size(), 32U) << plain << " nests deeper, and that has a bound";
        return;
    }
    ASSERT_EQ(again.size(), tokens.size()) << plain;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        EXPECT_TRUE(again[i].kind == tokens[i].kind && again[i].operand == tokens[i].operand &&
                    again[i].op == tokens[i].op)
            << plain;
    }
}

void test_words(const std::string& text) {
    if (const auto cube = host::parse_frame(text)) {
        EXPECT_TRUE(host::is_cube(*cube));
        const auto again = host::parse_frame(host::frame_text(*cube));
        ASSERT_TRUE(again.has_value()) << host::frame_text(*cube);
        EXPECT_TRUE(host::same_cube(*cube, *again));
    }
    if (const auto budget = host::parse_node_budget(text)) {
        EXPECT_LE(*budget, NodePool::max_capacity);
        EXPECT_EQ(host::parse_node_budget(std::to_string(*budget)), budget);
    }
    if (text.find('\0') == std::string::npos) {
        EXPECT_EQ(host::identifier_fault(host::identifier_of(text)), "") << host::identifier_of(text);
    }
}

} // namespace

void run(Choices& choices) {
    const std::uint32_t kind = choices.below(8);
    const std::vector<std::uint8_t> rest = choices.rest();
    if (kind < 4) {
        test_mesh(static_cast<Format>(kind), rest);
    } else if (kind < 6) {
        test_tree(rest, kind == 5);
    } else if (kind == 6) {
        test_expression(std::string(rest.begin(), rest.end()));
    } else {
        test_words(std::string(rest.begin(), rest.end()));
    }
}

} // namespace osem::fuzz
