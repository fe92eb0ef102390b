// classify against exact clipping for random faces and octants, most of them degenerate in some way.
#include <gtest/gtest.h>

#include <cstdio>

#include "cell_grid.hpp"
#include "exact_face.hpp"
#include "face_case.hpp"
#include "level.hpp"
#include "osem/classify.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

struct Tally {
    std::uint64_t pairs = 0;
    std::uint64_t met = 0;
    std::uint64_t stages[osem::stage_count][2] = {};
};

void test_case(unsigned seed, Tally& tally) {
    FaceCase random(seed);
    const TestSolid face = random.face();
    const FacePieces pieces = pieces_of(face.view_with_tables(), 0);
    for (const osem::Solid& view : {face.view(), face.view_with_tables()}) {
        const osem::CheckedSolid solid = osem::CheckedSolid::vouched(view);
        for (const osem::Octant& octant : random.octants()) {
            const osem::Decision decision = osem::classify(solid, 0, octant);
            const bool expected = meets_open(pieces, octant);
            ASSERT_EQ(decision.meets, expected) << "seed " << seed << ", octant " << in_words(octant);
            ASSERT_EQ(decision.stage == osem::Stage::minimax, !boxes_overlap(face, octant))
                << "seed " << seed << ", octant " << in_words(octant);
            ++tally.pairs;
            tally.met += decision.meets ? 1U : 0U;
            ++tally.stages[static_cast<unsigned>(decision.stage)][decision.meets ? 1 : 0];
        }
    }
}

TEST(PredicateOracle, ClassifyAgreesWithClipping) {
    const unsigned cases = is_full() ? 40000 : 6000;
    Tally tally;
    for (unsigned seed = 1; seed <= cases && !testing::Test::HasFatalFailure(); ++seed) {
        test_case(seed, tally);
    }
    std::printf("%llu pairs, %llu meet\n", static_cast<unsigned long long>(tally.pairs),
                static_cast<unsigned long long>(tally.met));
    for (unsigned s = 0; s < osem::stage_count; ++s) {
        std::printf("stage %u: %llu rejected, %llu accepted\n", s + 1,
                    static_cast<unsigned long long>(tally.stages[s][0]),
                    static_cast<unsigned long long>(tally.stages[s][1]));
    }
    // Every stage has been tried from either side, as far as it decides that way.
    EXPECT_GT(tally.stages[0][0], 1000U);
    EXPECT_GT(tally.stages[1][0], 1000U);
    EXPECT_GT(tally.stages[2][1], 1000U);
    EXPECT_GT(tally.stages[3][0], 1000U);
    EXPECT_GT(tally.stages[3][1], 1000U);
    EXPECT_GT(tally.stages[4][0], 100U);
    EXPECT_GT(tally.stages[4][1], 100U);
}

} // namespace

} // namespace oracle
