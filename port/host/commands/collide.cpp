// osem collide: whether two octree files, one of them moved, collide or touch.
#include <memory>
#include <ostream>
#include <string>

#include <CLI/CLI.hpp>

#include "commands/command.hpp"
#include "commands/world_point.hpp"
#include "files/decimal.hpp"
#include "files/host_pool.hpp"
#include "files/tree_file.hpp"
#include "mesh/bad_input.hpp"
#include "osem/collide.hpp"

namespace osem::host {

namespace {

struct CollideArguments {
    std::string a;
    std::string b;
    Coordinates offset = {};
};

const char* contact_name(Contact contact) {
    switch (contact) {
    case Contact::clear:
        return "clear";
    case Contact::touch:
        return "touch";
    case Contact::possible:
        return "possible";
    default:
        return "certain";
    }
}

// Where b's root lies on a's lattice, moved by the offset.
Point lattice_offset(const TreeFile& a, const TreeFile& b, const Coordinates& offset) {
    const WorldCube& cube_a = a.facts().cube;
    const WorldCube& cube_b = b.facts().cube;
    if (cube_a.side != cube_b.side) {
        throw BadInput("the cells differ: " + a.path() + " has a cube of side " + decimal(cube_a.side) +
                       ", " + b.path() + " one of " + decimal(cube_b.side));
    }
    Coordinates moved = {};
    for (std::size_t axis = 0; axis < 3; ++axis) moved[axis] = cube_b.origin[axis] + offset[axis];
    return on_lattice(moved, cube_a, Rounding::nearest);
}

void run_collide(const CollideArguments& options, std::ostream& out) {
    TreeFile file_a(options.a);
    TreeFile file_b(options.b);
    const Point offset = lattice_offset(file_a, file_b, options.offset);
    HostPool pool_a(file_a.nodes());
    HostPool pool_b(file_b.nodes());
    const auto job = std::make_unique<Collision>();
    const CollisionOutcome found =
        collide(*job, file_a.read(pool_a.pool()), file_b.read(pool_b.pool()), offset);
    require_ok(found.status);
    out << "contact " << contact_name(found.contact) << '\n' << "offset " << point_text(offset) << '\n';
    if (found.contact != Contact::clear) {
        out << "leaf_a " << leaf_text(found.a) << '\n' << "leaf_b " << leaf_text(found.b) << '\n';
    }
    out << "visited " << found.visited << '\n';
}

constexpr const char* collide_footer =
    "contact is certain (a cell is in black leaves of both), possible (a cell is in leaves of both that are\n"
    "black or boundary), touch (they share a point, but no cell) or clear. The two octrees need cubes of "
    "the\n"
    "same side; where their origins and the offset are no whole number of cells apart, B is moved to the\n"
    "nearest. leaf_a and leaf_b are a pair of leaves that meet so, each in its own root.";

} // namespace

void add_collide(CLI::App& app, const Console& console) {
    CLI::App* command = app.add_subcommand("collide", "Tell whether two octrees collide, touch or are clear");
    const auto options = std::make_shared<CollideArguments>();
    command->add_option("A", options->a, "Octree file")->required()->type_name("");
    command->add_option("B", options->b, "Octree file that is moved")->required()->type_name("");
    add_coordinates(*command, "--offset", options->offset, "How far B is moved, in world units");
    command->footer(collide_footer);
    command->callback([options, &console] { run_collide(*options, console.out); });
}

} // namespace osem::host
