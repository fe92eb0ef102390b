// Slices of trees as runs and as bitmaps.
#include "osem/slice.hpp"

#include "planted_tree.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

/// The runs of one row that a slicing hands out.
struct TakenRuns {
    PixelRun* runs;
    std::int32_t count;
    std::int32_t capacity;
};

bool take_run(void* context, const PixelRun& run) {
    auto& taken = *static_cast<TakenRuns*>(context);
    if (taken.count == taken.capacity) return false;
    taken.runs[taken.count++] = run;
    return true;
}

/// The last row of a bitmap.
struct TakenRow {
    std::int32_t row;
    std::size_t bytes;
};

bool take_row(void* context, std::int32_t row, const std::uint8_t*, std::size_t bytes) {
    *static_cast<TakenRow*>(context) = {row, bytes};
    return true;
}

/// One kind of bitmap, drawn row by row.
struct Bitmap {
    BitmapSlicing job;
    TakenRow taken;
    std::uint8_t* buffer;
};

constexpr Bits all_bits[] = {Bits::outer, Bits::inner, Bits::both};

/// All forms of a slice, at the same row.
struct Work {
    RowWalk* walk;
    RunSlicing* slicing;
    TakenRuns taken;
    Bitmap* bitmaps;
};

bool take_work(Arena& arena, std::uint8_t level, Work& work) {
    const std::int32_t pixels = std::int32_t{1} << level;
    work.walk = arena.take<RowWalk>(1);
    work.slicing = arena.take<RunSlicing>(1);
    work.taken = {arena.take<PixelRun>(static_cast<std::size_t>(pixels)), 0, pixels};
    work.bitmaps = arena.take<Bitmap>(3);
    if (work.walk == nullptr || work.slicing == nullptr || work.taken.runs == nullptr) return false;
    if (work.bitmaps == nullptr) return false;
    for (unsigned i = 0; i < 3; ++i) {
        work.bitmaps[i].buffer = arena.take<std::uint8_t>(slice_buffer(level, all_bits[i]));
        if (work.bitmaps[i].buffer == nullptr) return false;
        work.bitmaps[i].taken = {-1, 0};
    }
    return true;
}

// The statuses of all beginnings.
bool begin(Report& report, const Octree& tree, const Slice& slice, Work& work, Status expected) {
    bool as_expected = true;
    const auto expect = [&](Status found) {
        as_expected &=
            report.expect("status of a slice", static_cast<int>(expected), static_cast<int>(found));
    };
    expect(work.walk->begin(tree, slice));
    expect(work.slicing->begin(tree, slice, RunSink{take_run, &work.taken}));
    for (unsigned i = 0; i < 3; ++i) {
        Bitmap& bitmap = work.bitmaps[i];
        expect(bitmap.job.begin(tree, slice, all_bits[i], bitmap.buffer,
                                slice_buffer(slice.level, all_bits[i]), RowSink{take_row, &bitmap.taken}));
    }
    return as_expected;
}

void replay_bitmaps(Reader& reader, Report& report, const Work& work, std::int32_t row, std::uint8_t level) {
    const std::size_t bytes = slice_row_bytes(level);
    for (unsigned i = 0; i < 3; ++i) {
        Bitmap& bitmap = work.bitmaps[i];
        bitmap.job.step(1);
        report.expect("row of a bitmap", row, bitmap.taken.row);
        report.expect("bytes of a row", static_cast<std::int64_t>(slice_buffer(level, all_bits[i])),
                      static_cast<std::int64_t>(bitmap.taken.bytes));
    }
    for (unsigned i = 0; i < 2; ++i) {
        for (std::size_t byte = 0; byte < bytes; ++byte) {
            const std::uint8_t expected = reader.u8();
            report.expect("byte of a bitmap", expected, work.bitmaps[i].buffer[byte]);
            report.expect("byte of both bitmaps", expected, work.bitmaps[2].buffer[i * bytes + byte]);
        }
    }
}

void expect_run(Report& report, const PixelRun& expected, const PixelRun& found) {
    report.expect("row of a run", expected.row, found.row);
    report.expect("start of a run", expected.start, found.start);
    report.expect("length of a run", expected.length, found.length);
    report.expect("colour of a run", static_cast<int>(expected.colour), static_cast<int>(found.colour));
}

// The walk answers white runs too, the slicing leaves them out.
void replay_runs(Reader& reader, Report& report, Work& work, std::int32_t row) {
    PixelRun expected = {row, 0, 0, Colour::white};
    PixelRun found = {};
    std::int32_t sliced = 0;
    work.taken.count = 0;
    work.slicing->step(1);
    work.walk->enter(row);
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        expected.length = reader.u8();
        expected.colour = static_cast<Colour>(reader.u8());
        report.expect("one more run", 1, work.walk->next(found) ? 1 : 0);
        expect_run(report, expected, found);
        if (expected.colour != Colour::white) {
            if (sliced < work.taken.count) expect_run(report, expected, work.taken.runs[sliced]);
            ++sliced;
        }
        expected.start += expected.length;
    }
    report.expect("no more run", 0, work.walk->next(found) ? 1 : 0);
    report.expect("runs handed out", sliced, work.taken.count);
}

void replay_slice(Reader& reader, Arena& arena, Report& report, const Octree& tree) {
    const auto axis = static_cast<Axis>(reader.u8());
    const std::int32_t cell = reader.i32();
    const Slice slice = {axis, cell, reader.u8()};
    const auto status = static_cast<Status>(reader.u8());
    const std::uint16_t bytes = reader.u16();
    const ArenaScope scope(arena);
    Work work = {};
    if (!take_work(arena, slice.level, work)) {
        report.too_large();
        reader.skip(bytes);
        return;
    }
    report.begin_case();
    if (!begin(report, tree, slice, work, status) || status != Status::ok) {
        reader.skip(bytes);
        return;
    }
    for (std::int32_t row = 0; row < work.walk->rows(); ++row) {
        replay_bitmaps(reader, report, work, row, slice.level);
        replay_runs(reader, report, work, row);
    }
    report.expect("status at the end", static_cast<int>(Status::ok),
                  static_cast<int>(work.slicing->finish().status));
    for (unsigned i = 0; i < 3; ++i) {
        report.expect("status at a bitmap's end", static_cast<int>(Status::ok),
                      static_cast<int>(work.bitmaps[i].job.finish().status));
    }
}

} // namespace

bool replay_slice(Reader& reader, Arena& arena, Report& report) {
    const PlantedTree planted(reader, arena);
    if (!planted.fits()) return false;
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        replay_slice(reader, arena, report, planted.tree());
    }
    return true;
}

} // namespace osem::cross
