// osem check: what the solid in a mesh file is.
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/solid_input.hpp"
#include "files/decimal.hpp"
#include "mesh/topology.hpp"

namespace osem::host {

namespace {

void print(std::ostream& out, const IntegerSolid& solid, const Topology& t) {
    const double unit = solid.cube.unit();
    out << "faces " << t.faces << '\n'
        << "rings " << t.rings << '\n'
        << "hole_rings " << t.hole_rings << '\n'
        << "vertices " << t.vertices << '\n'
        << "edges " << t.edges << '\n'
        << "shells " << t.shells << '\n'
        << "manifold " << (t.manifold ? "yes" : "no") << '\n'
        << "genus " << (t.genus ? std::to_string(*t.genus) : "undefined") << '\n'
        << "volume " << decimal(t.volume6 / 6 * unit * unit * unit) << '\n'
        << "frame " << frame_text(solid.cube) << '\n'
        << "input_faces " << solid.input_faces << '\n'
        << "input_vertices " << solid.input_vertices << '\n'
        << "welded_vertices " << solid.welded_vertices << '\n'
        << "dropped_faces " << solid.dropped_faces << '\n'
        << "triangulated_faces " << solid.triangulated_faces << '\n'
        << "reoriented_faces " << solid.reoriented_faces << '\n';
}

void run_check(const std::string& input, std::ostream& out) {
    const IntegerSolid solid = read_solid(input, SolidOptions());
    static_cast<void>(check_solid(input, solid));
    print(out, solid, topology(solid));
}

constexpr const char* check_footer =
    "Prints one \"key value\" line each. First of the integer solid: faces, rings, hole_rings, vertices, "
    "edges,\n"
    "shells (faces joined by edges), manifold yes or no, genus (the sum over the shells; undefined unless\n"
    "manifold), signed volume in cubed world units (parts that overlap count once for each), frame\n"
    "X,Y,Z,SIDE. Then how it came from the file:\n"
    "input_faces, input_vertices, welded_vertices (merged with one on the same lattice point), "
    "dropped_faces\n"
    "(fewer than three corners after rounding), triangulated_faces (not planar on the lattice, by "
    "rounding\n"
    "or as the file has them: cut into triangles), reoriented_faces (turned over).\n"
    "Vertices with equal coordinates count as one: a surface that touches itself along an edge or in a "
    "point,\n"
    "as one that `osem mesh` wrote may, is not manifold here, though its file keeps the sheets apart.";

} // namespace

void add_check(CLI::App& app, const Console& console) {
    CLI::App* command =
        app.add_subcommand("check", "Say what the solid in a mesh file is, or why it is refused");
    const auto input = std::make_shared<std::string>();
    command->add_option("IN", *input, "Mesh file: .off, .stl, .obj or .poly")->required()->type_name("");
    command->footer(check_footer);
    command->callback([input, &console] { run_check(*input, console.out); });
}

} // namespace osem::host
