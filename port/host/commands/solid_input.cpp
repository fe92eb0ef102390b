#include "commands/solid_input.hpp"

#include "commands/choice.hpp"
#include "files/decimal.hpp"
#include "mesh/bad_input.hpp"
#include "mesh/read_mesh.hpp"

namespace osem::host {

namespace {

// What quantizing and checking find wrong says where in the solid; which file that was is known here.
template <class Work>
auto naming(const std::string& path, const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const BadInput& e) {
        throw BadInput(path + ": " + e.what());
    }
}

std::string frame_fault(const std::string& text) {
    return parse_frame(text) ? std::string() : "expected X,Y,Z,SIDE: four finite numbers, SIDE above 0";
}

} // namespace

void add_solid_options(CLI::App& command, SolidOptions& options) {
    add_choice<WindingRule>(
        command, "--winding", options.winding,
        "Which winding numbers are inside: nonzero (the default), odd (the default for .poly, whose facets "
        "are not oriented: crossing one changes between inside and outside) or positive",
        {{"nonzero", WindingRule::nonzero}, {"odd", WindingRule::odd}, {"positive", WindingRule::positive}})
        ->type_name("RULE");
    command
        .add_option(
            "--frame", options.frame,
            std::string("World cube that the root covers: its lowest corner X,Y,Z and its side. Default: ") +
                default_cube_rule)
        ->check(frame_fault)
        ->type_name("X,Y,Z,SIDE");
}

IntegerSolid read_solid(const std::string& path, const SolidOptions& options) {
    const Mesh mesh = read_mesh(path);
    const std::optional<WorldCube> cube = parse_frame(options.frame);
    return solid_in(cube ? *cube : naming(path, [&] { return default_cube(mesh); }), path, mesh);
}

IntegerSolid solid_in(const WorldCube& cube, const std::string& path, const Mesh& mesh) {
    return naming(path, [&] { return quantize(mesh, cube); });
}

WindingRule winding_rule(const SolidOptions& options, const IntegerSolid& solid) {
    // Without orientation a facet only says that crossing it changes between inside and outside.
    return options.winding.value_or(solid.oriented ? WindingRule::nonzero : WindingRule::odd);
}

CheckedSolid check_solid(const std::string& path, const IntegerSolid& solid) {
    return naming(path, [&] { return check_or_throw(solid); });
}

} // namespace osem::host
