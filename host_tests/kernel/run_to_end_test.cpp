// What jobs and counts have in common, at numbers that no job of a test comes to.
#include <gtest/gtest.h>

#include "tree/counts.hpp"
#include "tree/run_to_end.hpp"

namespace osem::tests {

namespace {

struct LongJob {
    int left;
    std::uint64_t units = 0;

    bool step(std::uint32_t budget) {
        units += budget;
        return --left > 0;
    }
};

TEST(RunToEnd, GoesOnAsLongAsAnythingIsLeft) {
    for (const int steps : {1, 2, 5}) {
        LongJob job = {steps};
        run_to_end(job);
        EXPECT_EQ(job.left, 0);
        EXPECT_EQ(job.units, static_cast<std::uint64_t>(steps) * UINT32_MAX);
    }
}

TEST(Counts, StayAtTheGreatest) {
    const std::uint32_t values[] = {0, 1, 8, UINT32_MAX - 8, UINT32_MAX - 1, UINT32_MAX};
    for (const std::uint32_t count : values) {
        for (const std::uint32_t more : values) {
            const std::uint64_t sum = std::uint64_t{count} + more;
            EXPECT_EQ(counted(count, more), sum > UINT32_MAX ? UINT32_MAX : sum);
        }
    }
}

} // namespace

} // namespace osem::tests
