// Whatever writes to a sink, with each of its writes refused in turn and in steps of several sizes: what was
// taken before is what an undisturbed run wrote, nothing comes after, and another run writes it all.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "osem/boundary.hpp"
#include "osem/slice.hpp"
#include "osem/stream_boolean.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/effort.hpp"
#include "support/heap_pool.hpp"
#include "support/slices.hpp"
#include "support/surface.hpp"

namespace osem::tests {

namespace {

// Takes writes of any kind until one is to be refused.
struct Gate {
    std::vector<Bytes> taken;
    std::size_t room = SIZE_MAX; ///< writes that are taken
    bool refused = false;
    bool replaced = false; ///< the first bytes of all, by the last write

    bool take(Bytes write) {
        EXPECT_FALSE(refused) << "a write after a refusal";
        refused = taken.size() == room;
        if (!refused) taken.push_back(std::move(write));
        return !refused;
    }
    Bytes all() const {
        Bytes bytes;
        for (const Bytes& write : taken) {
            const bool first = replaced && &write == &taken.back();
            if (!first) bytes.insert(bytes.end(), write.begin(), write.end());
        }
        if (replaced) std::copy(taken.back().begin(), taken.back().end(), bytes.begin());
        return bytes;
    }
    static Gate& of(void* context) { return *static_cast<Gate*>(context); }
    Sink sink() {
        return {[](void* context, const std::uint8_t* bytes, std::size_t count) {
                    return of(context).take(Bytes(bytes, bytes + count));
                },
                this};
    }
    Sink replacing_sink() {
        Sink to = sink();
        to.replace = [](void* context, const std::uint8_t* bytes, std::size_t count) {
            of(context).replaced = of(context).take(Bytes(bytes, bytes + count));
            return of(context).replaced;
        };
        return to;
    }
    RunSink runs() {
        return {[](void* context, const PixelRun& run) {
                    const std::int32_t words[] = {run.row, run.start, run.length,
                                                  static_cast<std::int32_t>(run.colour)};
                    return of(context).take(bytes_of(words));
                },
                this};
    }
    RowSink rows() {
        return {[](void* context, std::int32_t, const std::uint8_t* bytes, std::size_t count) {
                    return of(context).take(Bytes(bytes, bytes + count));
                },
                this};
    }
    BoundarySink surface() {
        return {[](void* context, const Point& at) { return of(context).take(bytes_of(at)); },
                [](void* context, std::uint32_t vertex) { return of(context).take(bytes_of(vertex)); },
                [](void* context) { return of(context).take({'r'}); },
                [](void* context) { return of(context).take({'f'}); }, this};
    }
};

// `run` drives a job that lives on from run to run; `expected` is all that is to be written.
struct SinkJob {
    std::string name;
    Bytes expected;
    std::function<Status(Gate&, std::uint32_t budget)> run;
};
void PrintTo(const SinkJob& job, std::ostream* out) { *out << job.name; }

// Streams of these are written in several pieces, whatever their size.
DenseGrid first_grid() { return random_grid(5, 31, three_colours); }
DenseGrid second_grid() { return random_grid(5, 32, three_colours); }
DenseGrid sliced_grid() { return random_grid(4, 31, three_colours); }

// A tree with a pool of its own.
struct OwnTree {
    HeapPool pool{4000};
    Octree tree;
    explicit OwnTree(const DenseGrid& grid) : tree(planted(grid, *pool)) {}
};

void tell(StreamBuilder& builder, const std::vector<Colour>& colours) {
    for (const Colour colour : colours) {
        if (colour == Colour::grey) {
            builder.open();
        } else {
            builder.leaf(colour);
        }
    }
}

// In two passes, or in one where the sink can replace.
std::vector<SinkJob> stream_jobs(bool once) {
    const auto own = std::make_shared<OwnTree>(first_grid());
    const auto a = std::make_shared<const Bytes>(stream_of(first_grid()));
    const auto b = std::make_shared<const Bytes>(stream_of(second_grid()));
    const auto job = std::make_shared<StreamCombination>();
    const std::string passes = once ? "_in_one_pass" : "";
    const auto sink_of = [once](Gate& gate) { return once ? gate.replacing_sink() : gate.sink(); };
    // A refusal of the first write of a single pass is begin's as well.
    const auto run = [=](Status begun, std::uint32_t budget) {
        EXPECT_TRUE(begun == Status::ok || (once && begun == Status::sink_refused));
        drive(*job, {budget});
        return job->finish().status;
    };
    std::vector<SinkJob> jobs = {
        {"write_stream" + passes, *a,
         [=](Gate& gate, std::uint32_t) { return write_stream(own->tree, StreamHeader{}, sink_of(gate)); }},
        {"stream_builder" + passes, *a,
         [=](Gate& gate, std::uint32_t) {
             const std::vector<Colour> colours = preorder_colours(preorder_masks(first_grid()));
             StreamBuilder builder;
             StreamHeader header = {};
             header.depth = 5;
             if (!once) {
                 builder.begin();
                 tell(builder, colours);
                 header.nodes = static_cast<std::uint32_t>(builder.nodes());
             }
             builder.begin(header, sink_of(gate));
             tell(builder, colours);
             EXPECT_EQ(builder.taken(), !gate.refused);
             const Status status = builder.finish();
             EXPECT_EQ(builder.finish(), status) << "asked again";
             return status;
         }},
        {"stream_complement" + passes, stream_of(complemented(first_grid())),
         [=](Gate& gate, std::uint32_t budget) {
             return run(job->begin_complement(memory_source(a->data(), a->size()), sink_of(gate)), budget);
         }}};
    for (const Operator op :
         {Operator::unite, Operator::intersect, Operator::subtract, Operator::exclusive_or}) {
        jobs.push_back({"stream_operator_" + std::to_string(static_cast<int>(op)) + passes,
                        stream_of(combined(op, first_grid(), second_grid())),
                        [=](Gate& gate, std::uint32_t budget) {
                            return run(job->begin(op, memory_source(a->data(), a->size()),
                                                  memory_source(b->data(), b->size()), sink_of(gate)),
                                       budget);
                        }});
    }
    return jobs;
}

std::vector<SinkJob> slice_jobs() {
    const auto own = std::make_shared<OwnTree>(sliced_grid());
    std::vector<SinkJob> jobs;
    for (const Axis axis : {axis_x, axis_y, axis_z}) {
        const Slice slice = {axis, root_side / 2, 4};
        const Rows rows = expected_rows(sliced_grid(), slice);
        Bytes runs;
        Bytes bits;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            for (const PixelRun& run : runs_of(rows[row], static_cast<int>(row), false)) {
                const std::int32_t words[] = {run.row, run.start, run.length,
                                              static_cast<std::int32_t>(run.colour)};
                const Bytes bytes = bytes_of(words);
                runs.insert(runs.end(), bytes.begin(), bytes.end());
            }
            for (const bool inner : {false, true}) {
                const Bytes bytes = bits_of(rows[row], inner);
                bits.insert(bits.end(), bytes.begin(), bytes.end());
            }
        }
        const std::string along = std::to_string(static_cast<int>(axis));
        jobs.push_back({"runs_" + along, runs, [=](Gate& gate, std::uint32_t budget) {
                            RunSlicing job;
                            EXPECT_EQ(job.begin(own->tree, slice, gate.runs()), Status::ok);
                            drive(job, {budget});
                            return job.finish().status;
                        }});
        jobs.push_back(
            {"bitmaps_" + along, bits, [=](Gate& gate, std::uint32_t budget) {
                 Bytes buffer(slice_buffer(4, Bits::both));
                 BitmapSlicing job;
                 EXPECT_EQ(job.begin(own->tree, slice, Bits::both, buffer.data(), buffer.size(), gate.rows()),
                           Status::ok);
                 drive(job, {budget});
                 return job.finish().status;
             }});
    }
    return jobs;
}

// What a surface in arrays comes to as the calls of a sink.
Bytes calls_of(const Solid& solid) {
    Gate gate;
    const BoundarySink to = gate.surface();
    for (std::uint32_t v = 0; v < solid.vertex_count; ++v) to.vertex(&gate, solid.vertices[v]);
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
            const Ring ring = solid.ring(r);
            for (std::uint32_t i = 0; i < ring.count; ++i) to.corner(&gate, ring.corners[i]);
            to.end_ring(&gate);
        }
        to.end_face(&gate);
    }
    return gate.all();
}

// A surface that can be emitted, and what it stands on.
struct BuiltSurface {
    OwnTree own;
    std::vector<BoundaryCorner> scratch;
    Boundary job;

    BuiltSurface(const DenseGrid& grid, SolidPart part, std::uint32_t corners) : own(grid), scratch(corners) {
        job.begin(own.tree, part, scratch.data(), corners);
        drive(job, Effort());
        EXPECT_EQ(job.finish().status, Status::ok);
    }
};

std::vector<SinkJob> surface_jobs() {
    const DenseGrid grid = random_grid(3, 17, three_colours);
    const OwnTree own(grid);
    std::vector<SinkJob> jobs;
    for (const SolidPart part : {SolidPart::inner, SolidPart::outer}) {
        Boundary counting;
        const Surface surface(counting, own.tree, part);
        EXPECT_EQ(covered_faces(surface.view(), 3), expected_faces(solid_cells(grid, part)));
        const auto built = std::make_shared<BuiltSurface>(grid, part, surface.counted().sizes.corners);
        jobs.push_back({part == SolidPart::inner ? "inner_surface" : "outer_surface",
                        calls_of(surface.view()), [built](Gate& gate, std::uint32_t budget) {
                            EXPECT_EQ(built->job.emit(gate.surface()), Status::ok);
                            drive(built->job, {budget});
                            return built->job.finish().status;
                        }});
    }
    return jobs;
}

std::vector<SinkJob> sink_jobs() {
    std::vector<SinkJob> jobs = stream_jobs(false);
    for (const auto& more : {stream_jobs(true), slice_jobs(), surface_jobs()})
        jobs.insert(jobs.end(), more.begin(), more.end());
    return jobs;
}

class SinkFaults : public ::testing::TestWithParam<SinkJob> {};

TEST_P(SinkFaults, StepsOfEverySizeWriteTheSame) {
    for (const std::uint32_t budget : step_budgets) {
        Gate gate;
        ASSERT_EQ(GetParam().run(gate, budget), Status::ok);
        ASSERT_EQ(gate.all(), GetParam().expected) << "budget " << budget;
    }
}

TEST_P(SinkFaults, EveryWriteMayBeRefused) {
    Gate whole;
    ASSERT_EQ(GetParam().run(whole, UINT32_MAX), Status::ok);
    ASSERT_GT(whole.taken.size(), 3U);
    for (std::size_t at = 0; at < whole.taken.size(); ++at) {
        const std::uint32_t budget = step_budgets[at % step_budget_count];
        Gate gate;
        gate.room = at;
        ASSERT_EQ(GetParam().run(gate, budget), Status::sink_refused) << "write " << at;
        ASSERT_TRUE(gate.refused);
        const auto end = whole.taken.begin() + static_cast<std::ptrdiff_t>(at);
        ASSERT_EQ(gate.taken, std::vector<Bytes>(whole.taken.begin(), end)) << "write " << at;
        if (at % 8 != 0) continue;
        Gate again;
        ASSERT_EQ(GetParam().run(again, budget), Status::ok);
        ASSERT_EQ(again.all(), GetParam().expected);
    }
}

INSTANTIATE_TEST_SUITE_P(All, SinkFaults, ::testing::ValuesIn(sink_jobs()),
                         [](const auto& job) { return job.param.name; });

} // namespace

} // namespace osem::tests
