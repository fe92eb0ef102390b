// osem mesh: the surface of an octree as a mesh file.
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/choice.hpp"
#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "console/progress.hpp"
#include "files/host_pool.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/write_surface.hpp"

namespace osem::host {

namespace {

struct MeshArguments {
    std::string input;
    std::string output;
    SolidPart part = SolidPart::inner;
};

std::string format_fault(const std::string& name) {
    return surface_format(name) ? std::string() : "expected a name that ends in .off, .obj, .stl or .poly";
}

TreeSurface surface_for(const MeshArguments& options, const Octree& tree, SurfaceFormat format,
                        const Console& console) {
    TreeSurface surface;
    {
        Progress progress(console, "meshing");
        surface = surface_of(tree, options.part, [&progress](std::uint64_t part, std::uint64_t whole) {
            progress.show(part, whole);
        });
    }
    if (format == SurfaceFormat::poly) return surface;
    Progress progress(console, "triangulating");
    return in_simple_faces(
        surface, format != SurfaceFormat::stl,
        [&progress](std::uint64_t part, std::uint64_t whole) { progress.show(part, whole); });
}

void run_mesh(const MeshArguments& options, const Console& console) {
    refuse_same_file("--output", options.output, "the input", options.input);
    const SurfaceFormat format = *surface_format(options.output);
    OutputFile::probe(options.output);
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    const TreeSurface surface = surface_for(options, tree, format, console);
    if (surface.face_count() == 0) throw BadInput(options.input + ": the solid is empty and has no surface");

    OutputFile output(options.output);
    write_surface(output.stream(), surface, file.facts().cube, format);
    console.out << "vertices " << surface.vertices.size() << '\n'
                << "faces " << surface.face_count() << '\n'
                << "double_edges " << surface.double_edges << '\n';
    finish_printing(console);
    output.commit();
}

constexpr const char* mesh_footer =
    "The inner solid is the black leaves, the outer one the black and the boundary leaves. The surface is\n"
    "closed, faces outwards and is a 2-manifold: where two cubes of the solid meet in an edge or a corner "
    "only,\n"
    "each has vertices of its own. A face is a whole connected piece of a plane. OFF and OBJ know no holes: "
    "faces\n"
    "that have some, or pass through a point twice, are cut into triangles; STL is binary, all triangles; a\n"
    ".poly file keeps every face whole. Converting the file at the octree's depth and frame gives its "
    "leaves\n"
    "back, the boundary leaves white (inner) or black (outer).\n"
    "Prints vertices and faces of the file, and double_edges: edges of one lattice unit (depth 20) that two\n"
    "sheets of the surface share with both ends.";

} // namespace

void add_mesh(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("mesh", "Write the surface of an octree as a mesh file");
    const auto options = std::make_shared<MeshArguments>();
    command->add_option("X", options->input, "Octree file")->required()->type_name("");
    add_output(*command, "-o,--output", options->output, "Mesh file to write: .off, .obj, .stl or .poly")
        ->required()
        ->check(format_fault)
        ->type_name("OUT");
    add_choice<SolidPart>(*command, "--solid", options->part, "Which solid: inner or outer. Default: inner",
                          {{"inner", SolidPart::inner}, {"outer", SolidPart::outer}})
        ->type_name("SOLID");
    command->footer(mesh_footer);
    command->callback([options, &console] { run_mesh(*options, console); });
}

} // namespace osem::host
