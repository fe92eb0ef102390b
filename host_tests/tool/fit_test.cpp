// osem convert by either technique and to fit, and osem coarsen, on boxes whose octrees follow from algebra.
#include "support.hpp"

namespace osem::tool_test {

namespace {

constexpr std::uint64_t cells_at_depth_4 = std::uint64_t{1} << 48; // lattice cells in a leaf of depth 4

std::string cells(std::uint64_t leaves) { return std::to_string(leaves * cells_at_depth_4); }

/// A box at the distance of a leaf of depth 4 from the root's sides: 14^3 such leaves are black, the rest
/// white. Every octant at the root's sides divides: 8 of depth 1, 4^3 - 2^3 of depth 2 and 8^3 - 6^3 of depth
/// 3, so 360 nodes and the top one.
class Fit : public Tool {
  protected:
    Ran convert(const std::vector<std::string>& options, const std::string& depth = "4") {
        write_file(path("box.off"), box_off({0.0625, 0.0625, 0.0625}, {0.9375, 0.9375, 0.9375}));
        std::vector<std::string> line = {"convert", path("box.off"), "-o",      path("box.osem"),
                                         "--frame", "0,0,0,1",       "--depth", depth};
        line.insert(line.end(), options.begin(), options.end());
        return osem(line);
    }

    /// The report of coarsening that box.
    std::map<std::string, std::string> coarsen(const std::string& nodes) {
        EXPECT_TRUE(succeeded(convert({})));
        const Ran ran = osem({"coarsen", path("box.osem"), "--nodes", nodes, "-o", path("coarse.osem")});
        EXPECT_TRUE(succeeded(ran));
        return table(ran.out);
    }
};

TEST_F(Fit, AllTechniquesGiveTheSameFile) {
    ASSERT_TRUE(succeeded(convert({"--technique", "divide"})));
    const std::string divided = read_file(path("box.osem"));
    const Ran grids = convert({"--stats"});
    ASSERT_TRUE(succeeded(grids));
    EXPECT_EQ(read_file(path("box.osem")), divided);
    EXPECT_EQ(table(grids.out)["nodes"], "361");
    EXPECT_EQ(table(grids.out)["grids"], "1"); // up to 32 x 32 x 32 leaves are one
    const Ran ran = convert({"--technique", "bintree", "--stats"});
    ASSERT_TRUE(succeeded(ran));
    EXPECT_EQ(read_file(path("box.osem")), divided);
    auto report = table(ran.out);
    EXPECT_EQ(report["components"], "2"); // inside and outside
    EXPECT_EQ(report["nodes"], "361");
    EXPECT_EQ(report.count("octants"), 0U);
    EXPECT_EQ(info("box")["volume_inner"], cells(14 * 14 * 14));
}

TEST_F(Fit, AnyThreadsGiveTheSameFile) {
    for (const char* const leaves : {"conservative", "centre"}) {
        for (const char* const depth : {"5", "6", "7"}) {
            ASSERT_TRUE(succeeded(convert({"--technique", "divide", "--leaves", leaves}, depth)));
            const std::string divided = read_file(path("box.osem"));
            for (const char* const threads : {"1", "2", "3", "8"}) {
                const Ran ran = convert({"--threads", threads, "--leaves", leaves, "--stats"}, depth);
                ASSERT_TRUE(succeeded(ran));
                EXPECT_EQ(read_file(path("box.osem")), divided) << threads;
                EXPECT_GE(std::stoul(table(ran.out)["grids"]), depth[0] == '5' ? 1U : 8U);
            }
        }
    }
    EXPECT_EQ(convert({"--threads", "2", "--technique", "divide"}).code, 1);
    EXPECT_EQ(convert({"--threads", "2", "--fit", "100"}).code, 1);
    EXPECT_EQ(convert({"--threads", "9"}).code, 1);
}

TEST_F(Fit, ARodHasMoreNodesThanItsAreaLetsExpect) {
    // A lattice unit thick, from side to side of the root: one octant of each level for each of its lengths.
    make_box("rod", {349525, 349525, 0}, {349526, 349526, 1048576},
             {"--depth", "15", "--technique", "divide"}, "0,0,0,1048576");
    EXPECT_EQ(info("rod")["nodes"], "32767");
    EXPECT_EQ(info("rod")["boundary"], "32768");
    const std::string divided = read_file(path("rod.osem"));
    const std::vector<std::string> ways[] = {
        {"--threads", "1"}, {"--threads", "2"}, {"--threads", "8"}, {"--technique", "bintree"}};
    for (const std::vector<std::string>& way : ways) {
        make_box("other", {349525, 349525, 0}, {349526, 349526, 1048576}, {"--depth", "15", way[0], way[1]},
                 "0,0,0,1048576");
        EXPECT_EQ(read_file(path("other.osem")), divided) << way[1];
    }
}

TEST_F(Fit, LabellingAlternatesAcrossNestedBoxes) {
    // A box, a box-shaped cavity in it and a box in that: three shells, each an eighth from the next.
    const std::vector<std::string> shells = {box_off({0.125, 0.125, 0.125}, {0.875, 0.875, 0.875}),
                                             box_off({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}),
                                             box_off({0.375, 0.375, 0.375}, {0.625, 0.625, 0.625})};
    std::string vertices;
    for (const std::string& shell : shells) {
        const std::size_t first = shell.find("0\n") + 2;
        vertices += shell.substr(first, shell.find("4 0 2 3 1") - first);
    }
    const std::string faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"
                              "4 9 11 10 8\n4 14 15 13 12\n4 12 13 9 8\n4 11 15 14 10\n4 10 14 12 8\n"
                              "4 13 15 11 9\n4 16 18 19 17\n4 20 21 23 22\n4 16 17 21 20\n4 18 22 23 19\n"
                              "4 16 20 22 18\n4 17 19 23 21\n";
    write_file(path("nested.off"), "OFF\n24 18 0\n" + vertices + faces);
    const Ran ran = osem({"convert", path("nested.off"), "-o", path("nested.osem"), "--frame", "0,0,0,1",
                          "--depth", "4", "--technique", "bintree", "--stats"});
    ASSERT_TRUE(succeeded(ran));
    EXPECT_EQ(table(ran.out)["components"], "4");
    const std::string inside = cells(12 * 12 * 12 - 8 * 8 * 8 + 4 * 4 * 4);
    EXPECT_EQ(info("nested")["volume_inner"], inside);
    EXPECT_EQ(info("nested")["volume_outer"], inside);
}

TEST_F(Fit, TheFinestDepthThatFits) {
    const std::vector<std::pair<std::string, std::string>> depths = {
        {"360", "4"}, {"359", "3"}, {"64", "3"}, {"63", "2"}, {"8", "2"}, {"7", "1"}, {"0", "1"}};
    for (const auto& [nodes, depth] : depths) {
        const Ran ran = convert({"--fit", nodes});
        ASSERT_TRUE(succeeded(ran)) << nodes;
        EXPECT_EQ(table(ran.out)["depth"], depth) << nodes;
        const std::string fitted = read_file(path("box.osem"));
        ASSERT_TRUE(succeeded(convert({}, depth)));
        EXPECT_EQ(fitted, read_file(path("box.osem"))) << nodes;
    }
}

TEST_F(Fit, MemoryIsGivenInNodesOfSixBytes) {
    EXPECT_EQ(table(convert({"--fit", "2160B"}).out)["depth"], "4"); // 360 nodes
    EXPECT_EQ(table(convert({"--fit", "2159B"}).out)["depth"], "3");
    EXPECT_EQ(table(convert({"--fit", "3KB"}).out)["depth"], "4"); // 512 nodes
    EXPECT_EQ(table(convert({"--fit", "2KB"}).out)["depth"], "3"); // 341 nodes
    EXPECT_EQ(table(convert({"--fit", "1MB"}).out)["depth"], "4");
    EXPECT_TRUE(failed(convert({"--fit", "2GB"}), 1, "--fit"));
    EXPECT_TRUE(failed(convert({"--fit", "much"}), 1, "--fit"));
}

TEST_F(Fit, ContradictionsAreRefused) {
    EXPECT_TRUE(failed(convert({"--technique", "guess"}), 1, "--technique"));
    EXPECT_TRUE(failed(convert({"--technique", "bintree", "--leaves", "centre"}), 1, "centre"));
    EXPECT_TRUE(failed(convert({"--technique", "bintree", "--fit", "100"}), 1, "--fit"));
    EXPECT_EQ(files(), std::vector<std::string>{"box.off"});
}

TEST_F(Fit, CoarseningWithinTheBudgetLosesNothing) {
    auto report = coarsen("360");
    EXPECT_EQ(report["nodes"], "360");
    EXPECT_EQ(report["inner_lost"], "0");
    EXPECT_EQ(report["outer_gained"], "0");
    EXPECT_EQ(report["above_optimum"], "0");
    EXPECT_EQ(info("coarse")["digest"], info("box")["digest"]);
}

TEST_F(Fit, CoarseningToNothingLeavesTheBoundary) {
    auto report = coarsen("0");
    EXPECT_EQ(report["nodes"], "0");
    EXPECT_EQ(report["inner_lost"], cells(14 * 14 * 14));
    EXPECT_EQ(report["outer_gained"], cells(16 * 16 * 16 - 14 * 14 * 14));
    EXPECT_EQ(info("coarse")["volume_inner"], "0");
    EXPECT_EQ(info("coarse")["volume_outer"], cells(16 * 16 * 16));
}

// A node of depth 2 at a side of the root keeps the colour of 32 leaves, at an edge of 16, at a corner of 8,
// as every node of depth 3 does. So of 56 nodes the best are those of depth 1 and the 24 + 24 at sides and
// edges: the octants of depth 3 along the surface are lost, and the 8 black ones in the corners of depth 2.
TEST_F(Fit, CoarseningKeepsTheNodesThatColourMost) {
    auto report = coarsen("56");
    EXPECT_EQ(report["nodes"], "56");
    const std::uint64_t lost = 14 * 14 * 14 - 12 * 12 * 12 + 8 * 8;
    const std::uint64_t gained = 16 * 16 * 16 - 14 * 14 * 14;
    EXPECT_EQ(report["inner_lost"], cells(lost));
    EXPECT_EQ(report["outer_gained"], cells(gained));
    EXPECT_EQ(report["above_optimum"], "0");
    EXPECT_EQ(info("coarse")["volume_inner"], cells(14 * 14 * 14 - lost));
    EXPECT_EQ(info("coarse")["volume_outer"], cells(14 * 14 * 14 + gained));
    EXPECT_EQ(info("coarse")["nodes"], "57");
}

TEST_F(Fit, CoarseningMayReplaceItsInput) {
    ASSERT_TRUE(succeeded(convert({})));
    ASSERT_TRUE(succeeded(osem({"coarsen", path("box.osem"), "--nodes", "8", "-o", path("box.osem")})));
    EXPECT_EQ(info("box")["nodes"], "9");
    EXPECT_TRUE(failed(osem({"coarsen", path("box.osem"), "-o", path("box.osem")}), 1, "--nodes"));
    EXPECT_TRUE(
        failed(osem({"coarsen", path("box.osem"), "--nodes", "-1", "-o", path("box.osem")}), 1, "--nodes"));
}

} // namespace

} // namespace osem::tool_test
