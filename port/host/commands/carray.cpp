// osem carray: an octree file or a mesh file to a C++ header of constants.
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/output_option.hpp"
#include "commands/solid_input.hpp"
#include "files/constants.hpp"
#include "files/host_pool.hpp"
#include "files/identifier.hpp"
#include "files/output_file.hpp"
#include "files/tree_file.hpp"

namespace osem::host {

namespace {

struct CarrayArguments {
    std::string input;
    std::string output;
    std::string name;
    SolidOptions solid;
};

ConstantsName name_of(const CarrayArguments& options) {
    return {options.name.empty() ? identifier_of(options.input) : options.name,
            std::filesystem::path(options.input).filename().string()};
}

void write_tree_header(const CarrayArguments& options) {
    TreeFile file(options.input);
    HostPool pool(file.nodes());
    const Octree tree = file.read(pool.pool());
    OutputFile output(options.output);
    write_constants(output.stream(), name_of(options), tree, file.facts());
    output.commit();
}

void write_solid_header(const CarrayArguments& options) {
    const IntegerSolid solid = read_solid(options.input, options.solid);
    static_cast<void>(check_solid(options.input, solid));
    OutputFile output(options.output);
    write_constants(output.stream(), name_of(options), solid, winding_rule(options.solid, solid));
    output.commit();
}

void run_carray(const CarrayArguments& options) {
    const bool from_tree = is_tree_name(options.input);
    if (from_tree && !options.solid.frame.empty()) {
        throw CLI::ValidationError("--frame", "an octree file has a frame of its own");
    }
    if (from_tree && options.solid.winding) {
        throw CLI::ValidationError("--winding", "an octree file has no winding rule");
    }
    refuse_same_file("--output", options.output, "the input", options.input);
    OutputFile::probe(options.output);
    from_tree ? write_tree_header(options) : write_solid_header(options);
}

constexpr const char* carray_footer =
    "An octree becomes nodes, pool and tree in the namespace NAME: a tree that osem::leaf_at and\n"
    "osem::colours_in read where it lies, with 32-bit and with 16-bit indices. A mesh becomes vertices,\n"
    "corners, ring_starts, face_rings (no ring tables for triangle meshes), solid and winding: the integer\n"
    "solid, checked, to be converted on the target. --winding and --frame are for meshes only.";

} // namespace

void add_carray(CLI::App& app, const Console&) {
    CLI::App* command =
        app.add_subcommand("carray", "Write an octree or a solid as C++ constants for firmware");
    const auto options = std::make_shared<CarrayArguments>();
    command->add_option("IN", options->input, "Octree file (.osem) or mesh file: .off, .stl, .obj or .poly")
        ->required()
        ->type_name("");
    add_output(*command, "-o,--output", options->output, "C++ header to write")
        ->required()
        ->type_name("OUT.hpp");
    command->add_option("--name", options->name, "Namespace of the constants. Default: from the name of IN")
        ->check(identifier_fault)
        ->type_name("NAME");
    add_solid_options(*command, options->solid);
    command->footer(carray_footer);
    command->callback([options] { run_carray(*options); });
}

} // namespace osem::host
