#include "commands/solid_input.hpp"

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

} // namespace

IntegerSolid read_solid(const std::string& path, const std::optional<WorldCube>& cube) {
    const Mesh mesh = read_mesh(path);
    return naming(path, [&] { return quantize(mesh, cube ? *cube : default_cube(mesh)); });
}

CheckedSolid check_solid(const std::string& path, const IntegerSolid& solid) {
    return naming(path, [&] { return check_or_throw(solid); });
}

} // namespace osem::host
