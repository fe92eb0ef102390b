// Scenarios of slices.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

bool add_run(void* context, const PixelRun& run) {
    auto& digest = *static_cast<Digest*>(context);
    digest.add(run.row);
    digest.add(run.start);
    digest.add(run.length);
    digest.add(run.colour);
    return true;
}

bool add_row(void* context, std::int32_t row, const std::uint8_t* bytes, std::size_t count) {
    auto& digest = *static_cast<Digest*>(context);
    digest.add(row);
    for (std::size_t i = 0; i < count; ++i) digest.add_byte(bytes[i]);
    return row != 13;
}

void add(Digest& digest, const SliceOutcome& outcome) {
    digest.add(outcome.status);
    digest.add(outcome.rows);
    digest.add(outcome.visited);
}

template <class Act>
void for_each_slice(Digest& digest, const Act& act) {
    constexpr std::int32_t cells[] = {-1, 0, root_side / 2 - 1, root_side / 2, 700000, root_side};
    constexpr std::uint8_t levels[] = {0, 2, 4, 5};
    ConvertOptions options;
    options.depth = 4;
    const Octree tree = converted(plate(), options).tree;
    digest.add(measure(tree).nodes);
    for (const Axis axis : {axis_x, axis_y, axis_z}) {
        for (const std::int32_t cell : cells) {
            for (const std::uint8_t level : levels) act(tree, Slice{axis, cell, level});
        }
    }
}

} // namespace

std::uint64_t slices_as_runs() {
    Digest digest;
    for_each_slice(digest, [&digest](const Octree& tree, const Slice& slice) {
        auto& job = fresh<RunSlicing>();
        digest.add(job.begin(tree, slice, RunSink{add_run, &digest}));
        while (job.step(3)) {
        }
        add(digest, job.finish());
    });
    return digest.value();
}

std::uint64_t slices_as_bitmaps() {
    struct Work {
        BitmapSlicing job;
        std::uint8_t row[slice_buffer(4, Bits::both)];
    };
    Digest digest;
    for_each_slice(digest, [&digest](const Octree& tree, const Slice& slice) {
        for (const Bits bits : {Bits::outer, Bits::inner, Bits::both}) {
            auto& work = fresh<Work>();
            digest.add(
                work.job.begin(tree, slice, bits, work.row, sizeof work.row, RowSink{add_row, &digest}));
            while (work.job.step(3)) {
            }
            add(digest, work.job.finish());
        }
    });
    return digest.value();
}

} // namespace osem::cross
