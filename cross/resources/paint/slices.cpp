// Slices as runs and as bitmaps.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

RowWalk walk;
RunSlicing runs;
BitmapSlicing bitmaps;
std::uint8_t row_buffer[slice_buffer(6, Bits::both)];

// Sinks that take everything, and no stack.
bool take_run(void*, const PixelRun&) { return true; }
bool take_row(void*, std::int32_t, const std::uint8_t*, std::size_t) { return true; }

void measure_rows(const Octree& tree, const Slice& slice) {
    Status status = Status::unfinished;
    measured("RowWalk::begin", [&] { status = walk.begin(tree, slice); });
    expect(status == Status::ok);
    measured("RowWalk::enter", [&] { walk.enter(walk.rows() / 2); });
    PixelRun run = {};
    bool found = false;
    measured("RowWalk::next", [&] {
        while (walk.next(run)) found = true;
    });
    expect(found);
}

void measure_runs(const Octree& tree, const Slice& slice) {
    SliceOutcome outcome = {};
    measured("RunSlicing::begin", [&] { runs.begin(tree, slice, RunSink{take_run, nullptr}); });
    measured("RunSlicing::step", [&] {
        while (runs.step(7)) {
        }
    });
    measured("RunSlicing::finish", [&] { outcome = runs.finish(); });
    expect(outcome.status == Status::ok);
}

void measure_bitmaps(const Octree& tree, const Slice& slice) {
    SliceOutcome outcome = {};
    measured("BitmapSlicing::begin", [&] {
        bitmaps.begin(tree, slice, Bits::both, row_buffer, sizeof row_buffer, RowSink{take_row, nullptr});
    });
    measured("BitmapSlicing::step", [&] {
        while (bitmaps.step(7)) {
        }
    });
    measured("BitmapSlicing::finish", [&] { outcome = bitmaps.finish(); });
    expect(outcome.status == Status::ok);
}

} // namespace

// At the tree's depth, and at a level where pixels are looked into.
void paint_slices(const PaintTrees& trees) {
    constexpr std::uint8_t levels[] = {6, 2, 0};
    for (const std::uint8_t level : levels) {
        const Slice slice = {axis_z, root_side / 2, level};
        measure_rows(trees.a, slice);
        measure_runs(trees.a, slice);
        measure_bitmaps(trees.a, slice);
    }
}

} // namespace osem::cross
