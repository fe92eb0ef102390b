#include "commands/world_point.hpp"

#include <cmath>

#include "files/decimal.hpp"
#include "mesh/bad_input.hpp"

namespace osem::host {

namespace {

constexpr double farthest = 536870912; // 2^29

} // namespace

CLI::Option* add_coordinates(CLI::App& command, const std::string& name, Coordinates& target,
                             const std::string& help) {
    const auto set = [&target](const std::string& text) {
        static_cast<void>(parse_decimals(text, target.data(), 3)); // checked before
    };
    const auto fault = [](const std::string& text) {
        Coordinates read = {};
        return parse_decimals(text, read.data(), 3) ? std::string() : "expected X,Y,Z";
    };
    return command.add_option_function<std::string>(name, set, help)->check(fault)->type_name("X,Y,Z");
}

Point on_lattice(const Coordinates& world, const WorldCube& cube, Rounding rounding) {
    Point point = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double exact = (world[axis] - cube.origin[axis]) * (root_side / cube.side);
        double rounded = std::floor(exact + 0.5);
        if (rounding == Rounding::down) rounded = std::floor(exact);
        if (rounding == Rounding::up) rounded = std::ceil(exact);
        if (!(std::abs(rounded) <= farthest)) {
            throw BadInput("coordinate " + decimal(world[axis]) + " is too far from the root");
        }
        point.at[axis] = static_cast<std::int32_t>(rounded);
    }
    return point;
}

std::string point_text(const Point& point) {
    return std::to_string(point.x()) + ' ' + std::to_string(point.y()) + ' ' + std::to_string(point.z());
}

std::string leaf_text(const Leaf& leaf) {
    return point_text(leaf.octant.corner) + ' ' + std::to_string(leaf.octant.side()) + ' ' +
           colour_name(leaf.colour);
}

std::string colour_name(Colour colour) {
    switch (colour) {
    case Colour::white:
        return "white";
    case Colour::black:
        return "black";
    case Colour::boundary:
        return "boundary";
    default:
        return "grey";
    }
}

void require_ok(Status status) {
    if (status != Status::ok) throw BadInput(describe(status));
}

} // namespace osem::host
