// osem transform and osem coarsen --depth, on boxes whose places are plain to see.
#include "support.hpp"

namespace osem::tool_test {

namespace {

class Transforms : public Tool {
  protected:
    // [0.25, 0.5) x [0.25, 0.75) x [0.5, 0.75), whole leaves at depth 3.
    void SetUp() override {
        Tool::SetUp();
        make_box("box", {0.25, 0.25, 0.5}, {0.5, 0.75, 0.75});
    }
    Ran transform(const std::string& from, const std::string& to,
                  const std::vector<std::string>& options) const {
        std::vector<std::string> all = {"transform", path(from), "-o", path(to)};
        all.insert(all.end(), options.begin(), options.end());
        return osem(all);
    }
    Ran coarsen(const std::vector<std::string>& options) const {
        std::vector<std::string> all = {"coarsen", path("box.osem"), "-o", path("coarse.osem")};
        all.insert(all.end(), options.begin(), options.end());
        return osem(all);
    }
    std::string leaves(const std::string& name) const {
        const Ran ran = osem({"leaves", path(name)});
        EXPECT_TRUE(succeeded(ran));
        return ran.out;
    }
};

TEST_F(Transforms, ThereAndBackIsTheSameTree) {
    ASSERT_TRUE(succeeded(transform("box.osem", "there.osem", {"--translate", "0.25,-0.25,0.125"})));
    make_box("moved", {0.5, 0, 0.625}, {0.75, 0.5, 0.875});
    EXPECT_EQ(leaves("there.osem"), leaves("moved.osem"));
    ASSERT_TRUE(succeeded(transform("there.osem", "back.osem", {"--translate", "-0.25,0.25,-0.125"})));
    EXPECT_EQ(read_file(path("back.osem")), read_file(path("box.osem")));
}

TEST_F(Transforms, ASymmetryAndItsInverseAreTheSameTree) {
    ASSERT_TRUE(succeeded(transform("box.osem", "turned.osem", {"--symmetry", "+y-x+z"})));
    make_box("image", {0.25, 0.5, 0.5}, {0.75, 0.75, 0.75});
    EXPECT_EQ(leaves("turned.osem"), leaves("image.osem"));
    ASSERT_TRUE(succeeded(transform("turned.osem", "back.osem", {"--symmetry", "-y+x+z"})));
    EXPECT_EQ(read_file(path("back.osem")), read_file(path("box.osem")));
}

TEST_F(Transforms, DownAndUpIsTheSameTree) {
    ASSERT_TRUE(succeeded(transform("box.osem", "small.osem", {"--down", "1", "--at", "0.5,0,0.5"})));
    make_box("half", {0.625, 0.125, 0.75}, {0.75, 0.375, 0.875}, {"--depth", "4"});
    EXPECT_EQ(leaves("small.osem"), leaves("half.osem"));
    const Ran up = transform("small.osem", "back.osem", {"--up", "1", "--at", "0.9,0.1,0.9"});
    ASSERT_TRUE(succeeded(up));
    EXPECT_EQ(up.out, "inner_dropped 0\nouter_dropped 0\n");
    EXPECT_EQ(read_file(path("back.osem")), read_file(path("box.osem")));
}

// Of the box, a 32nd of the root, the low octant of level 1 holds the half and that of level 2 nothing.
TEST_F(Transforms, ScalingUpSaysWhatItDrops) {
    make_box("half", {0.25, 0.25, 0.25}, {0.5, 0.75, 0.5});
    const Ran half = transform("half.osem", "up.osem", {"--up", "1"});
    ASSERT_TRUE(succeeded(half));
    const std::string dropped = std::to_string((std::uint64_t{1} << 60) / 64);
    EXPECT_EQ(half.out, "inner_dropped " + dropped + "\nouter_dropped " + dropped + "\n");
    const Ran all = transform("half.osem", "up.osem", {"--up", "2"});
    ASSERT_TRUE(succeeded(all));
    EXPECT_EQ(table(all.out)["inner_dropped"], info("half")["volume_inner"]);
}

// At an offset of half a leaf of the tree, exactness takes the next depth.
TEST_F(Transforms, AnOffsetBetweenTheLeavesWantsADepth) {
    const auto before = files();
    EXPECT_TRUE(failed(transform("box.osem", "no.osem", {"--translate", "0.0625,0,0"}), 2,
                       "--depth 4 places it exactly, with 4 times as many leaves or more"));
    EXPECT_TRUE(failed(transform("box.osem", "no.osem", {"--translate", "0,0.00000095367431640625,0"}), 2,
                       "--depth 20 places it exactly, with 17179869184 times"));
    EXPECT_TRUE(failed(transform("box.osem", "no.osem", {"--crop", "0,0,0,0.3125,1,1"}), 2, "--depth 4"));
    EXPECT_EQ(files(), before);
    ASSERT_TRUE(
        succeeded(transform("box.osem", "moved.osem", {"--translate", "0.0625,0,0", "--depth", "4"})));
    make_box("there", {0.3125, 0.25, 0.5}, {0.5625, 0.75, 0.75}, {"--depth", "4"});
    EXPECT_EQ(leaves("moved.osem"), leaves("there.osem"));
    ASSERT_TRUE(
        succeeded(transform("box.osem", "blurred.osem", {"--translate", "0.0625,0,0", "--depth", "3"})));
    EXPECT_EQ(info("blurred")["volume_outer"], std::to_string((std::uint64_t{1} << 60) * 3 / 64));
}

TEST_F(Transforms, ACropKeepsWhatLiesInTheBox) {
    ASSERT_TRUE(succeeded(transform("box.osem", "part.osem", {"--crop", "0,0.5,0,0.375,1,1"})));
    make_box("rest", {0.25, 0.5, 0.5}, {0.375, 0.75, 0.75});
    EXPECT_EQ(leaves("part.osem"), leaves("rest.osem"));
}

TEST_F(Transforms, WhatCannotBeDoneIsRefused) {
    const auto before = files();
    const auto refused = [this](const std::vector<std::string>& options, int code, const std::string& part) {
        return failed(transform("box.osem", "no.osem", options), code, part);
    };
    EXPECT_TRUE(refused({"--translate", "0.75,0,0"}, 2, "root"));
    EXPECT_TRUE(refused({"--translate", "0.3,0,0"}, 2,
                        "lattice unit, which is 9.5367431640625e-07; the nearest is 0.3000001907348633"));
    EXPECT_TRUE(refused({"--translate", "0.3,0"}, 1, "3 finite"));
    EXPECT_TRUE(refused({"--symmetry", "+x+x+z"}, 1, "each axis once"));
    EXPECT_TRUE(refused({"--down", "1", "--up", "1"}, 1, "wants one of"));
    EXPECT_TRUE(refused({}, 1, "wants one of"));
    EXPECT_TRUE(refused({"--up", "1", "--cut"}, 1, "--cut"));
    EXPECT_TRUE(refused({"--symmetry", "+y+x+z", "--at", "0,0,0"}, 1, "--at"));
    EXPECT_TRUE(refused({"--translate", "0.125,0,0", "--at", "0,0,0"}, 1, "--at"));
    EXPECT_TRUE(refused({"--up", "1", "--at", "2,0,0"}, 2, "outside the root"));
    EXPECT_EQ(files(), before);
}

// At level 1 the box lies in two octants, a quarter of the root's 2^60 cells, and fills an eighth of each; at
// level 2 it is two whole octants.
TEST_F(Transforms, CoarseningToADepthFollowsItsMode) {
    const std::string quarter = "288230376151711744";
    const auto volumes = [this](const std::string& mode) {
        const Ran ran = coarsen({"--depth", "1", "--mode", mode});
        EXPECT_TRUE(succeeded(ran)) << mode;
        auto found = table(ran.out);
        return found["inner_volume"] + " " + found["outer_volume"];
    };
    EXPECT_EQ(volumes("certified"), "0 " + quarter);
    EXPECT_EQ(volumes("inner"), "0 0");
    EXPECT_EQ(volumes("outer"), quarter + " " + quarter);
    EXPECT_EQ(volumes("majority"), "0 0");
    ASSERT_TRUE(succeeded(coarsen({"--depth", "2"})));
    EXPECT_EQ(info("coarse")["inner_volume"], info("box")["inner_volume"]);
    EXPECT_TRUE(failed(coarsen({}), 1, "either --nodes or --depth"));
    EXPECT_TRUE(failed(coarsen({"--depth", "1", "--nodes", "1"}), 1, "either --nodes or --depth"));
    EXPECT_TRUE(failed(coarsen({"--nodes", "1", "--mode", "inner"}), 1, "--mode"));
    EXPECT_TRUE(failed(coarsen({"--depth", "0"}), 1, "--depth"));
}

} // namespace

} // namespace osem::tool_test
