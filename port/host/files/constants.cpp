#include "files/constants.hpp"

#include <cmath>
#include <locale>
#include <vector>

#include "files/decimal.hpp"

namespace osem::host {

namespace {

constexpr std::size_t longest_line = 110;

std::string hexadecimal(std::uint8_t byte) {
    const char* const digits = "0123456789abcdef";
    return {'0', 'x', digits[byte >> 4], digits[byte & 15U]};
}

std::string node_text(const Node& node) {
    return "Node::of(" + hexadecimal(node.may) + ", " + hexadecimal(node.must) + ", " +
           std::to_string(node.first()) + ')';
}

std::string point_text(const Point& point) {
    return "{{" + std::to_string(point.x()) + ", " + std::to_string(point.y()) + ", " +
           std::to_string(point.z()) + "}}";
}

std::string index_text(std::uint32_t index) { return std::to_string(index); }

// Several entries a line.
template <class Entry, class TextOf>
void write_table(std::ostream& out, const char* declaration, const Entry* entries, std::size_t count,
                 const TextOf& text_of) {
    out << "inline constexpr " << declaration << "[] = {\n";
    std::string line;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string text = text_of(entries[i]);
        if (!line.empty() && line.size() + text.size() + 2 > longest_line) {
            out << line << '\n';
            line.clear();
        }
        line += (line.empty() ? "    " : " ") + text + ',';
    }
    out << line << "\n};\n";
}

void write_indices(std::ostream& out, const char* name, const std::vector<std::uint32_t>& indices) {
    out << '\n';
    write_table(out, (std::string("std::uint32_t ") + name).c_str(), indices.data(), indices.size(),
                index_text);
}

// A file's name must not end the comment that quotes it.
std::string printable(std::string name) {
    for (char& c : name) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    return name;
}

// "origin * 2^f" in a Q-format of f fraction bits; 0 and 2^0 need no factor.
std::string raw(double value) { return value == 0 ? "0" : decimal(value) + " * 2^f"; }

void write_world(std::ostream& out, const WorldCube& cube) {
    out << "//     world       the root cube is " << frame_text(cube) << " (X,Y,Z,SIDE)\n"
        << "//     unit        " << decimal(cube.unit()) << ", the side of a lattice cell\n";
    int exponent = 0;
    if (std::frexp(cube.side, &exponent) != 0.5) return; // a Frame's scale is a power of two
    out << "//     frame       {{" << raw(cube.origin[0]) << ", " << raw(cube.origin[1]) << ", "
        << raw(cube.origin[2]) << "}, " << lattice_bits - (exponent - 1)
        << " - f}\n//                 (an osem::Frame, where world coordinates have f fraction bits)\n";
}

void open_header(std::ostream& out, const ConstantsName& name, const char* what) {
    out.imbue(std::locale::classic()); // digits are not grouped
    out << "// " << what << " \"" << printable(name.source)
        << "\" as constants, written by osem carray.\n//\n";
}

// A tree and a solid of one name may stand in one program, so their guards differ.
void open_namespace(std::ostream& out, const ConstantsName& name, const char* kind, const char* header) {
    const std::string guard = std::string("OSEM_CARRAY_") + kind + '_' + name.space;
    out << "#ifndef " << guard << "\n#define " << guard << "\n\n#include <cstdint>\n\n#include \"osem/"
        << header << "\"\n\nnamespace " << name.space << " {\n\n";
}

void close_header(std::ostream& out, const ConstantsName& name) {
    out << "\n} // namespace " << name.space << "\n\n#endif\n";
}

const char* winding_text(WindingRule rule) {
    return rule == WindingRule::odd ? "odd" : rule == WindingRule::positive ? "positive" : "nonzero";
}

void describe_tree(std::ostream& out, const ConstantsName& name, const Octree& tree, const TreeFacts& facts) {
    const std::uint64_t nodes = tree.pool->used();
    open_header(out, name, "The octree");
    out << "//     depth       " << int{tree.depth} << "\n//     leaves      " << leaf_rule_name(facts.leaves)
        << '\n';
    write_world(out, facts.cube);
    out << "//     nodes       " << nodes << " and the top\n"
        << "//     flash       " << nodes * 6 << " bytes of nodes, " << nodes * 4
        << " with 16-bit indices\n//\n"
        << "// It is asked where it lies; nothing but kernel/src/query is compiled for that:\n//\n"
        << "//     const osem::PointOutcome at = osem::leaf_at(" << name.space << "::tree, {{x, y, z}});\n"
        << "//     const osem::BoxOutcome in = osem::colours_in(" << name.space
        << "::tree, {{{x0, y0, z0}}, {{x1, y1, z1}}});\n";
}

void describe_solid(std::ostream& out, const ConstantsName& name, const Solid& solid, const WorldCube& cube) {
    const bool tables = !solid.is_triangle_mesh();
    const std::uint64_t rings = solid.ring_count();
    const std::uint64_t words = std::uint64_t{3} * solid.vertex_count + solid.corner_count +
                                (tables ? rings + 1 + solid.face_count + 1 : 0);
    open_header(out, name, "The solid");
    write_world(out, cube);
    out << "//     vertices    " << solid.vertex_count << "\n//     corners     " << solid.corner_count
        << "\n//     rings       " << rings << "\n//     faces       " << solid.face_count
        << (tables ? "" : ", all triangles") << "\n//     flash       " << words * 4
        << " bytes of tables\n//\n"
        << "// osem::check has accepted it, so it can be vouched for:\n//\n"
        << "//     options.winding = " << name.space << "::winding;\n"
        << "//     osem::convert(job, osem::CheckedSolid::vouched(" << name.space
        << "::solid), options, faces, " << solid.face_count << ", &pool);\n";
}

} // namespace

void write_constants(std::ostream& out, const ConstantsName& name, const Octree& tree,
                     const TreeFacts& facts) {
    const std::uint32_t count = tree.pool->used();
    describe_tree(out, name, tree, facts);
    open_namespace(out, name, "TREE", "query.hpp");
    out << "using osem::Node;\n\n";
    if (count > 0) {
        out << "static_assert(" << count << " <= osem::NodePool::max_capacity,\n"
            << "              \"" << name.space
            << " has more nodes than OSEM_NODE_INDEX_BITS can count\");\n\n"
            << "// may, must and the first grey child of each node\n";
        write_table(out, "Node nodes", &tree.pool->at(0), count, node_text);
        out << '\n';
    }
    out << "inline constexpr osem::NodePool pool = osem::NodePool::over(" << (count > 0 ? "nodes" : "nullptr")
        << ", " << count << ");\n"
        << "inline constexpr osem::Octree tree = {&pool, " << node_text(tree.top) << ", " << int{tree.depth}
        << "};\n";
    close_header(out, name);
}

void write_constants(std::ostream& out, const ConstantsName& name, const IntegerSolid& solid,
                     WindingRule winding) {
    const Solid view = solid.view();
    describe_solid(out, name, view, solid.cube);
    open_namespace(out, name, "SOLID", "convert.hpp");
    write_table(out, "osem::Point vertices", solid.vertices.data(), solid.vertices.size(), point_text);
    write_indices(out, "corners", solid.corners);
    if (!view.is_triangle_mesh()) {
        write_indices(out, "ring_starts", solid.ring_starts);
        write_indices(out, "face_rings", solid.face_rings);
    }
    out << "\ninline constexpr osem::Solid solid = {\n    vertices, " << view.vertex_count << ", corners, "
        << view.corner_count
        << (view.is_triangle_mesh() ? ", nullptr, nullptr, " : ", ring_starts, face_rings, ")
        << view.face_count << "};\n"
        << "inline constexpr osem::WindingRule winding = osem::WindingRule::" << winding_text(winding)
        << ";\n";
    close_header(out, name);
}

} // namespace osem::host
