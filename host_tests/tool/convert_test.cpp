// osem check, convert and info on boxes, whose octrees follow from algebra.
#include <cmath>

#include "support.hpp"

namespace osem::tool_test {

namespace {

constexpr std::uint64_t cells_at_depth_3 = std::uint64_t{1} << 51; // lattice cells in a leaf of depth 3

TEST_F(Tool, CheckDescribesABox) {
    write_file(path("box.off"), box_off({-1, 0, 2}, {1, 3, 4}));
    const Ran ran = osem({"check", path("box.off")});
    ASSERT_TRUE(succeeded(ran));
    auto report = table(ran.out);
    EXPECT_EQ(report["faces"], "6");
    EXPECT_EQ(report["rings"], "6");
    EXPECT_EQ(report["hole_rings"], "0");
    EXPECT_EQ(report["vertices"], "8");
    EXPECT_EQ(report["edges"], "12");
    EXPECT_EQ(report["shells"], "1");
    EXPECT_EQ(report["manifold"], "yes");
    EXPECT_EQ(report["genus"], "0");
    EXPECT_EQ(report["input_faces"], "6");
    EXPECT_EQ(report["input_vertices"], "8");
    EXPECT_EQ(report["welded_vertices"], "0");
    EXPECT_EQ(report["dropped_faces"], "0");
    EXPECT_NEAR(std::stod(report["volume"]), 2 * 3 * 2, 1e-3); // rounding moves a face by half a unit at most
}

TEST_F(Tool, AnOpenSurfaceIsRefused) {
    std::string off = box_off({0, 0, 0}, {1, 1, 1});
    off.replace(off.find("8 6 0"), 5, "8 5 0");
    off.erase(off.find("4 1 3 7 5"));
    write_file(path("open.off"), off);
    const Ran ran = osem({"check", path("open.off")});
    EXPECT_TRUE(failed(ran, 2, "open.off: "));
    EXPECT_TRUE(ran.out.empty());
}

TEST_F(Tool, ABoxOnLeafBordersHasNoBoundary) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    auto report = info("box");
    EXPECT_EQ(report["depth"], "3");
    EXPECT_EQ(report["leaf_rule"], "conservative");
    EXPECT_EQ(report["frame"], "0,0,0,1");
    EXPECT_EQ(report["nodes"], "9");  // the root and its eight octants,
    EXPECT_EQ(report["black"], "8");  // each with one octant inside the box
    EXPECT_EQ(report["white"], "56"); // and seven outside
    EXPECT_EQ(report["boundary"], "0");
    EXPECT_EQ(report["volume_inner"], std::to_string(std::uint64_t{1} << 57));
    EXPECT_EQ(report["volume_outer"], std::to_string(std::uint64_t{1} << 57));
    EXPECT_EQ(report["volume_inner_world"], "0.125");
    EXPECT_EQ(report["volume_outer_world"], "0.125");
    EXPECT_EQ(report["digest"].find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(report["digest"].size(), 16U);
}

TEST_F(Tool, ABoxBetweenLeafBordersHasABoundaryAround) {
    make_box("box", {0.0625, 0.0625, 0.0625}, {0.9375, 0.9375, 0.9375});
    auto report = info("box");
    EXPECT_EQ(report["volume_inner"], std::to_string(6 * 6 * 6 * cells_at_depth_3));
    EXPECT_EQ(report["volume_outer"], std::to_string(8 * 8 * 8 * cells_at_depth_3));
    EXPECT_EQ(report["boundary"], std::to_string(8 * 8 * 8 - 6 * 6 * 6));
    EXPECT_EQ(report["volume_inner_world"], "0.421875");
}

TEST_F(Tool, CentreLeavesTakeTheColourOfTheirCentre) {
    // The leaves' centres stand at 4/64, 12/64, ... 60/64: seven of them lie between 3/64 and 59/64.
    const double low = 3.0 / 64;
    const double high = 59.0 / 64;
    make_box("box", {low, low, low}, {high, high, high}, {"--depth", "3", "--leaves", "centre"});
    auto report = info("box");
    EXPECT_EQ(report["leaf_rule"], "centre");
    EXPECT_EQ(report["boundary"], "0");
    EXPECT_EQ(report["volume_inner"], std::to_string(7 * 7 * 7 * cells_at_depth_3));
    EXPECT_EQ(report["volume_outer"], report["volume_inner"]);
}

TEST_F(Tool, FramesMayBeNegative) {
    for (const std::vector<std::string>& frame : {std::vector<std::string>{"--frame", "-1,-1,-1,2"},
                                                  std::vector<std::string>{"--frame=-1,-1,-1,2"}}) {
        write_file(path("box.off"), box_off({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
        std::vector<std::string> line = {"convert", path("box.off"), "-o", path("box.osem")};
        line.insert(line.end(), frame.begin(), frame.end());
        ASSERT_TRUE(succeeded(osem(line)));
        auto report = info("box");
        EXPECT_EQ(report["frame"], "-1,-1,-1,2");
        EXPECT_EQ(report["volume_inner"], std::to_string(std::uint64_t{1} << 57));
        EXPECT_EQ(report["volume_inner_world"], "1");
        EXPECT_EQ(report["depth"], "8"); // the default
    }
}

TEST_F(Tool, ASolidOutsideTheFrameIsRefused) {
    write_file(path("box.off"), box_off({0, 0, 0}, {2, 2, 2}));
    EXPECT_TRUE(failed(osem({"convert", path("box.off"), "-o", path("box.osem"), "--frame", "0,0,0,1"}), 2,
                       "box.off"));
    EXPECT_EQ(files(), std::vector<std::string>{"box.off"});
}

TEST_F(Tool, TheDeepestTrees) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}, {"--depth", "20"});
    make_box("centre", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}, {"--depth", "19", "--leaves", "centre"});
    EXPECT_EQ(info("box")["depth"], "20");
    EXPECT_EQ(info("centre")["depth"], "19");
    EXPECT_EQ(info("box")["digest"], info("centre")["digest"]); // no leaf is at full depth
}

TEST_F(Tool, WindingRulesDiffer) {
    // Two boxes with one half in common: there the winding number is 2.
    std::string off = box_off({0, 0, 0}, {0.5, 1, 1});
    const std::string other = box_off({0.25, 0, 0}, {0.75, 1, 1});
    const auto vertices = [](const std::string& text) {
        const std::size_t first = text.find("0\n") + 2;
        return text.substr(first, text.find("4 0 2 3 1") - first);
    };
    off = "OFF\n16 12 0\n" + vertices(off) + vertices(other) + off.substr(off.find("4 0 2 3 1")) +
          "4 8 10 11 9\n4 12 13 15 14\n4 8 9 13 12\n4 10 14 15 11\n4 8 12 14 10\n4 9 11 15 13\n";
    write_file(path("two.off"), off);
    const auto volume = [&](const std::string& rule) {
        EXPECT_TRUE(succeeded(osem({"convert", path("two.off"), "-o", path("two.osem"), "--frame", "0,0,0,1",
                                    "--depth", "3", "--winding", rule})));
        return info("two")["volume_inner_world"];
    };
    EXPECT_EQ(volume("nonzero"), "0.75");
    EXPECT_EQ(volume("positive"), "0.75");
    EXPECT_EQ(volume("odd"), "0.5");
}

TEST_F(Tool, CrossingShellsOfAPolyAreOddUnlessSaidOtherwise) {
    std::string poly = "16 3 0 0\n";
    for (unsigned k = 0; k < 16; ++k) {
        const unsigned low = k < 8 ? 0 : 2;
        poly += std::to_string(k);
        for (const unsigned bit : {1U, 2U, 4U}) poly += ' ' + std::to_string((k & bit) != 0 ? low + 4 : low);
        poly += '\n';
    }
    poly += "12 0\n";
    for (const unsigned base : {0U, 8U}) {
        for (const auto& face : {std::vector<unsigned>{0, 2, 3, 1},
                                 {4, 5, 7, 6},
                                 {0, 1, 5, 4},
                                 {2, 6, 7, 3},
                                 {0, 4, 6, 2},
                                 {1, 3, 7, 5}}) {
            poly += "1 0\n4";
            for (const unsigned corner : face) poly += ' ' + std::to_string(base + corner);
            poly += '\n';
        }
    }
    write_file(path("two.poly"), poly + "0\n");
    const auto volume = [&](const std::vector<std::string>& rule) {
        std::vector<std::string> line = {"convert", path("two.poly"), "-o",      path("two.osem"),
                                         "--frame", "0,0,0,8",        "--depth", "3"};
        line.insert(line.end(), rule.begin(), rule.end());
        EXPECT_TRUE(succeeded(osem(line)));
        return info("two")["volume_inner_world"];
    };
    EXPECT_EQ(volume({}), "112"); // 4^3 + 4^3 - 2 * 2^3
    EXPECT_EQ(volume({"--winding", "odd"}), "112");
    EXPECT_NE(volume({"--winding", "nonzero"}), "112");
}

TEST_F(Tool, StatsNameTheFiveStages) {
    write_file(path("box.off"), box_off({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}));
    const Ran ran = osem({"convert", path("box.off"), "-o", path("box.osem"), "--frame", "0,0,0,1", "--depth",
                          "3", "--technique", "divide", "--stats"});
    ASSERT_TRUE(succeeded(ran));
    std::size_t at = ran.out.find("stage");
    for (const char* word : {"rejected", "accepted", "minimax", "plane", "vertices", "section", "holes"}) {
        const std::size_t next = ran.out.find(word, at);
        ASSERT_NE(next, std::string::npos) << word;
        at = next;
    }
    // The root, its eight octants, and their eight octants each, which no face meets.
    EXPECT_NE(ran.out.find("\noctants 73\n"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\nnodes 9\n"), std::string::npos);
    EXPECT_NE(ran.out.find("\nns_per_octant "), std::string::npos);
}

TEST_F(Tool, TheQuantizedSolidConvertsToTheSameTree) {
    make_box("box", {0.1, 0.2, 0.3}, {0.7, 0.8, 0.9}, {"--depth", "6", "--quantized", path("q.off")});
    ASSERT_TRUE(succeeded(
        osem({"convert", path("q.off"), "-o", path("q.osem"), "--depth", "6", "--frame", "0,0,0,1048576"})));
    EXPECT_EQ(info("q")["digest"], info("box")["digest"]);
    EXPECT_EQ(info("q")["volume_inner"], info("box")["volume_inner"]);
    EXPECT_NE(read_file(path("q.off")).find("104858"), std::string::npos); // 0.1 * 2^20 = 104857.6
    EXPECT_TRUE(failed(osem({"convert", path("box.off"), "-o", path("same"), "--quantized", path("same")}), 1,
                       "--quantized"));
}

TEST_F(Tool, ConversionIsRepeatable) {
    make_box("a", {0.1, 0.2, 0.3}, {0.7, 0.8, 0.9}, {"--depth", "6"});
    make_box("b", {0.1, 0.2, 0.3}, {0.7, 0.8, 0.9}, {"--depth", "6"});
    EXPECT_EQ(read_file(path("a.osem")), read_file(path("b.osem")));
}

} // namespace

} // namespace osem::tool_test
