// Stock removal on the part itself: converts the bundled bracket, whose faces have hole rings, and a slanted
// cutter, subtracts the cutter, and answers point and box queries about what is left. Runs on a Cortex-M0
// with 16 KB of RAM: the solids lie in flash, all other memory is static and stands in this file.
#include "bracket.hpp" // made by `osem carray` from bracket.poly
#include "cutter.hpp"  // made by `osem carray` from cutter.off
#include "osem/osem.hpp"
#include "platform.hpp"

namespace {

using osem::port::print;
using osem::port::print_hexadecimal;
using osem::port::print_number;

constexpr int depth = 6; // leaves of 2 mm
constexpr std::int32_t mm = osem::root_side / 128;
constexpr std::uint32_t most_faces = osem::convert_scratch(bracket::solid);
static_assert(osem::convert_scratch(cutter::solid) <= most_faces, "the scratch is for both solids");

osem::StaticNodePool<2450> pool;
osem::Conversion conversion;
osem::Combination combination;
std::uint32_t faces[most_faces];

// What a firmware does between two slices of the work: feed the watchdog, show progress.
void feed_watchdog() {}

bool failed(const char* what, const osem::TreeOutcome& outcome) {
    if (outcome.status == osem::Status::ok) return false;
    print(what);
    print(": ");
    print(osem::describe(outcome.status));
    print(", nodes missing: ");
    print_number(outcome.nodes_missing);
    print("\n");
    return true;
}

void report(const char* what, std::uint64_t visited, const osem::TreeOutcome& outcome) {
    print(what);
    print(": visited ");
    print_number(visited);
    print(", new nodes ");
    print_number(outcome.nodes_needed);
    print("\n");
}

osem::TreeOutcome converted(const char* name, const osem::Solid& solid, osem::WindingRule winding) {
    osem::ConvertOptions options;
    options.depth = depth;
    options.winding = winding;
    // The host has checked what it put into the header.
    conversion.begin(osem::CheckedSolid::vouched(solid), options, faces, most_faces, &pool);
    while (conversion.step(100)) feed_watchdog();
    const osem::TreeOutcome outcome = conversion.finish();
    report(name, conversion.octants_visited(), outcome);
    return outcome;
}

osem::TreeOutcome subtracted(const osem::Octree& stock, const osem::Octree& tool) {
    combination.begin(osem::Operator::subtract, stock, tool, pool);
    while (combination.step(100)) feed_watchdog();
    const osem::TreeOutcome outcome = combination.finish();
    report("difference", combination.nodes_visited(), outcome);
    return outcome;
}

const char* name_of(osem::Colour colour) {
    return colour == osem::Colour::white ? "white" : colour == osem::Colour::black ? "black" : "boundary";
}

void ask_point(const osem::Octree& tree, std::int32_t x, std::int32_t y, std::int32_t z, const char* where) {
    const osem::PointOutcome at = osem::leaf_at(tree, osem::Point{{x * mm, y * mm, z * mm}});
    print(where);
    print(": ");
    print(at.status == osem::Status::ok ? name_of(at.leaf.colour) : osem::describe(at.status));
    print("\n");
}

void ask_box(const osem::Octree& tree, const osem::CellBox& box, const char* where) {
    const osem::BoxOutcome in = osem::colours_in(tree, box);
    print(where);
    print(in.clear()                      ? ": clear"
          : in.all(osem::Colour::white)   ? ": touches"
          : in.all(osem::Colour::black)   ? ": solid"
          : in.holds(osem::Colour::black) ? ": collides"
                                          : ": may collide");
    print("\n");
}

void ask(const osem::Octree& left) {
    ask_point(left, 30, 20, 14, "point in the base");
    ask_point(left, 84, 36, 14, "point in the hole");
    ask_point(left, 46, 58, 22, "point in the cut");
    ask_point(left, 16, 60, 90, "point in the wall");
    ask_box(left, {{{82 * mm, 34 * mm, 0}}, {{86 * mm, 38 * mm, 60 * mm}}}, "drill down the hole");
    ask_box(left, {{{28 * mm, 18 * mm, 12 * mm}}, {{34 * mm, 24 * mm, 18 * mm}}}, "block in the base");
    ask_box(left, {{{60 * mm, 90 * mm, 20 * mm}}, {{70 * mm, 100 * mm, 40 * mm}}}, "probe into the base");
    ask_box(left, {{{60 * mm, 20 * mm, 24 * mm}}, {{70 * mm, 30 * mm, 40 * mm}}}, "probe onto the base");
}

void print_figures(const osem::Octree& left) {
    const osem::Measures m = osem::measure(left);
    constexpr int cells_per_mm3 = 39; // as a power of two
    print("volume: ");
    print_number(m.inner_volume >> cells_per_mm3);
    print(" to ");
    print_number(m.outer_volume >> cells_per_mm3);
    print(" mm^3\nnodes: ");
    print_number(m.nodes);
    print("\npool: peak ");
    print_number(pool.peak());
    print(" of ");
    print_number(pool.capacity());
    print("\ndigest ");
    print_hexadecimal(osem::digest(left));
    print("\n");
}

} // namespace

int main() {
    const osem::TreeOutcome stock = converted("bracket", bracket::solid, bracket::winding);
    if (failed("bracket", stock)) return 1;
    const osem::TreeOutcome tool = converted("cutter", cutter::solid, cutter::winding);
    if (failed("cutter", tool)) return 1;
    const osem::TreeOutcome left = subtracted(stock.tree, tool.tree);
    if (failed("difference", left)) return 1;
    ask(left.tree);
    print_figures(left.tree);
    return 0;
}
