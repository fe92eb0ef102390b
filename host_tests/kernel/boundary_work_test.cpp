// The surface job as work: passes, steps, refusals.
#include <gtest/gtest.h>

#include <vector>

#include "osem/boundary.hpp"
#include "support/heap_pool.hpp"
#include "support/surface.hpp"

namespace osem::tests {

namespace {

// Everything a sink is told, and a place at which it refuses.
struct Log {
    std::vector<std::int64_t> calls;
    std::size_t room = SIZE_MAX;

    bool take(std::int64_t what) {
        if (calls.size() == room) return false;
        calls.push_back(what);
        return true;
    }
    static Log& of(void* context) { return *static_cast<Log*>(context); }
    static bool vertex(void* context, const Point& p) {
        return of(context).take((std::int64_t{p.x()} << 42) + (std::int64_t{p.y()} << 21) + p.z());
    }
    static bool corner(void* context, std::uint32_t index) {
        return of(context).take(-3 - std::int64_t{index});
    }
    static bool end_ring(void* context) { return of(context).take(-1); }
    static bool end_face(void* context) { return of(context).take(-2); }
    BoundarySink sink() { return {vertex, corner, end_ring, end_face, this}; }
};

struct BoundaryWork : ::testing::Test {
    HeapPool pool{5000};
    Octree tree = planted(random_grid(4, 17, three_colours), *pool);
    Boundary job;
    std::vector<BoundaryCorner> scratch;

    void run(std::uint32_t units = 100) {
        while (job.step(units)) {
        }
    }
    std::uint32_t count() {
        job.begin(tree, SolidPart::outer, nullptr, 0);
        run();
        return job.finish().sizes.corners;
    }
    void build(std::uint32_t units = 100) {
        scratch.resize(count());
        job.begin(tree, SolidPart::outer, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
        run(units);
    }
};

TEST_F(BoundaryWork, TheCountingPassNeedsNoScratchAndKnowsWhatTheSurfaceTakes) {
    const std::uint32_t corners = count();
    const BoundaryOutcome counted = job.finish();
    EXPECT_GT(corners, 0U);
    EXPECT_EQ(counted.status, Status::ok);
    EXPECT_EQ(counted.sizes.rings, 0U);
    EXPECT_EQ(job.emit(Log().sink()), Status::unfinished);
}

TEST_F(BoundaryWork, OneEntryTooFewIsRefusedWithTheNumberMissing) {
    const std::uint32_t corners = count();
    for (const std::uint32_t room : {corners - 1, corners / 2, std::uint32_t{1}}) {
        scratch.assign(room, BoundaryCorner{});
        job.begin(tree, SolidPart::outer, scratch.data(), room);
        run();
        const BoundaryOutcome outcome = job.finish();
        EXPECT_EQ(outcome.status, Status::scratch_too_small);
        EXPECT_EQ(outcome.scratch_missing, corners - room);
        EXPECT_EQ(outcome.sizes.corners, corners);
        EXPECT_EQ(job.emit(Log().sink()), Status::unfinished);
    }
}

TEST_F(BoundaryWork, TheSameSurfaceInStepsOfAnySize) {
    std::vector<std::int64_t> expected;
    for (const std::uint32_t units : {UINT32_MAX, 1U, 7U}) {
        build(units);
        const BoundarySizes sizes = job.finish().sizes;
        Log log;
        ASSERT_EQ(job.emit(log.sink()), Status::ok);
        run(units);
        EXPECT_EQ(job.finish().status, Status::ok);
        EXPECT_EQ(log.calls.size(), std::size_t{sizes.vertices} + sizes.corners + sizes.rings + sizes.faces);
        if (expected.empty()) expected = log.calls;
        EXPECT_TRUE(log.calls == expected);
    }
}

TEST_F(BoundaryWork, UnfinishedUntilNothingIsLeft) {
    EXPECT_EQ(Boundary().finish().status, Status::unfinished);
    EXPECT_FALSE(Boundary().step(1));
    scratch.resize(count());
    job.begin(tree, SolidPart::outer, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    std::uint64_t walked = 0;
    while (job.step(1)) {
        EXPECT_EQ(job.finish().status, Status::unfinished);
        EXPECT_EQ(job.emit(Log().sink()), Status::unfinished);
        EXPECT_GE(job.walked_volume(), walked);
        walked = job.walked_volume();
    }
    EXPECT_EQ(walked, root_volume);
    EXPECT_EQ(job.finish().status, Status::ok);
}

TEST_F(BoundaryWork, ASinkMayRefuseAnything) {
    build();
    Log whole;
    ASSERT_EQ(job.emit(whole.sink()), Status::ok);
    run();
    for (std::size_t room = 0; room < whole.calls.size(); room += 1 + room / 64) {
        Log log;
        log.room = room;
        ASSERT_EQ(job.emit(log.sink()), Status::ok);
        run();
        ASSERT_EQ(job.finish().status, Status::sink_refused) << room;
        ASSERT_EQ(log.calls.size(), room);
    }
    build(); // a refusal is not the next surface's
    EXPECT_EQ(job.finish().status, Status::ok);
    Log again; // and it may be emitted once more
    ASSERT_EQ(job.emit(again.sink()), Status::ok);
    run();
    EXPECT_EQ(job.finish().status, Status::ok);
    EXPECT_TRUE(again.calls == whole.calls);
}

// Nothing to store, so nothing is missing.
TEST_F(BoundaryWork, AnEmptySurfaceNeedsNoScratch) {
    job.begin(Octree::uniform(*pool, Colour::white), SolidPart::outer, nullptr, 0);
    run();
    Log log;
    ASSERT_EQ(job.emit(log.sink()), Status::ok);
    run();
    EXPECT_EQ(job.finish().status, Status::ok);
    EXPECT_TRUE(log.calls.empty());
}

TEST_F(BoundaryWork, TheWalkIsSeenToGoOnceMoreForTheVertices) {
    build();
    EXPECT_FALSE(job.step(1)) << "nothing is left until emit";
    EXPECT_EQ(job.finish().status, Status::ok);
    Log log;
    ASSERT_EQ(job.emit(log.sink()), Status::ok);
    EXPECT_EQ(job.walked_volume(), 0U);
    std::uint64_t walked = 0;
    bool was_part_of_it = false;
    while (job.step(1)) {
        EXPECT_GE(job.walked_volume(), walked);
        walked = job.walked_volume();
        was_part_of_it = was_part_of_it || (walked > 0 && walked < root_volume);
    }
    EXPECT_TRUE(was_part_of_it);
    EXPECT_EQ(job.walked_volume(), root_volume);
}

} // namespace

} // namespace osem::tests
