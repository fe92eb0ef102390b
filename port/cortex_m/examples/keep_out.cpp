// A keep-out zone watched while a machine moves: the zone's tree lies in flash as constants, and each step of
// a tool path is a box query. Of the kernel only the queries are linked; RAM is what the path's state takes.
#include "osem/query.hpp"
#include "platform.hpp"
#include "zone.hpp" // made by `osem carray` from a zone converted on the host

namespace {

using osem::port::print;
using osem::port::print_number;

constexpr std::int32_t mm = osem::root_side / 128;

// The tool: a box of 6 mm by 6 mm by 30 mm above its tip.
osem::CellBox tool_at(const osem::Point& tip) {
    return {{{tip.x() - 3 * mm, tip.y() - 3 * mm, tip.z()}},
            {{tip.x() + 3 * mm, tip.y() + 3 * mm, tip.z() + 30 * mm}}};
}

// The path: straight moves between these tips, one step a millimetre along the longest axis.
constexpr osem::Point tips[] = {
    {{84 * mm, 36 * mm, 90 * mm}}, // above the hole
    {{84 * mm, 36 * mm, 10 * mm}}, // down the hole, clear of its wall
    {{84 * mm, 36 * mm, 60 * mm}}, // and up
    {{64 * mm, 96 * mm, 40 * mm}}, // over to the base
    {{64 * mm, 96 * mm, 20 * mm}}, // into it
    {{64 * mm, 96 * mm, 60 * mm}}, // and out again
    {{12 * mm, 96 * mm, 60 * mm}}, // into the wall
};

struct Tally {
    std::uint32_t steps;
    std::uint32_t clear;
    std::uint32_t touching;
    std::uint32_t colliding;
    std::uint32_t visited;
};

void print_step(const osem::Point& tip, const char* what) {
    print("  tip at");
    for (const std::int32_t coordinate : tip.at) {
        print(" ");
        print_number(static_cast<std::uint64_t>(coordinate / mm));
    }
    print(what);
}

// One query a step, as a motion controller would ask before it lets the step happen.
void watch(const osem::Point& tip, Tally& tally, bool& was_clear) {
    const osem::BoxOutcome in = osem::colours_in(zone::tree, tool_at(tip));
    ++tally.steps;
    tally.visited += in.visited;
    const bool is_clear = in.clear();
    if (is_clear) {
        ++tally.clear;
    } else if (in.all(osem::Colour::white)) {
        ++tally.touching;
    } else {
        ++tally.colliding;
    }
    if (is_clear != was_clear) print_step(tip, is_clear ? ": clear again\n" : ": enters the zone\n");
    was_clear = is_clear;
}

std::int32_t magnitude(std::int32_t number) { return number < 0 ? -number : number; }

void follow(const osem::Point& from, const osem::Point& to, Tally& tally, bool& was_clear) {
    std::int32_t longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t way = magnitude(to.at[axis] - from.at[axis]);
        if (way > longest) longest = way;
    }
    const std::int32_t steps = longest / mm;
    for (std::int32_t step = 0; step < steps; ++step) {
        osem::Point tip = from;
        for (int axis = 0; axis < 3; ++axis) tip.at[axis] += (to.at[axis] - from.at[axis]) / steps * step;
        watch(tip, tally, was_clear);
    }
}

void print_count(const char* what, std::uint32_t count) {
    print(what);
    print_number(count);
}

} // namespace

int main() {
    Tally tally = {};
    bool was_clear = true;
    for (unsigned i = 1; i < sizeof tips / sizeof *tips; ++i) follow(tips[i - 1], tips[i], tally, was_clear);
    print_count("steps ", tally.steps);
    print_count(", clear ", tally.clear);
    print_count(", touching ", tally.touching);
    print_count(", colliding ", tally.colliding);
    print_count("; nodes visited ", tally.visited);
    print("\n");
    return 0;
}
