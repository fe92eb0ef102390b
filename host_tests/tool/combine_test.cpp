// osem union, intersection, difference, xor, complement and leaves.
#include <algorithm>
#include <sstream>

#include "support.hpp"

namespace osem::tool_test {

namespace {

class Combine : public Tool {
  protected:
    std::string volume(const std::vector<std::string>& line) {
        std::vector<std::string> all = line;
        all.insert(all.end(), {"-o", path("result.osem")});
        EXPECT_TRUE(succeeded(osem(all)));
        return info("result")["volume_inner_world"];
    }
};

TEST_F(Combine, VolumesOfTwoOverlappingBoxes) {
    make_box("a", {0, 0, 0}, {0.5, 1, 1});
    make_box("b", {0.25, 0, 0}, {1, 1, 1});
    const std::string a = path("a.osem");
    const std::string b = path("b.osem");
    EXPECT_EQ(volume({"union", a, b}), "1");
    EXPECT_EQ(volume({"intersection", a, b}), "0.25");
    EXPECT_EQ(volume({"difference", a, b}), "0.25");
    EXPECT_EQ(volume({"difference", b, a}), "0.5");
    EXPECT_EQ(volume({"xor", a, b}), "0.75");
    EXPECT_EQ(volume({"complement", b}), "0.25");
    EXPECT_EQ(volume({"difference", a, a}), "0");
}

TEST_F(Combine, TheResultKeepsTheFrameAndTheGreaterDepth) {
    make_box("a", {-1, -1, -1}, {0, 0, 0}, {"--depth", "2"}, "-1,-1,-1,4");
    make_box("b", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {"--depth", "5"}, "-1,-1,-1,4");
    EXPECT_EQ(volume({"union", path("a.osem"), path("b.osem")}), "1.875"); // 1 + 1 - 1/8
    EXPECT_EQ(info("result")["frame"], "-1,-1,-1,4");
    EXPECT_EQ(info("result")["depth"], "5");
}

TEST_F(Combine, ComplementTwiceIsTheOperand) {
    make_box("a", {0.1, 0.2, 0.3}, {0.7, 0.8, 0.9}, {"--depth", "6"});
    ASSERT_TRUE(succeeded(osem({"complement", path("a.osem"), "-o", path("b.osem")})));
    ASSERT_TRUE(succeeded(osem({"complement", path("b.osem"), "-o", path("c.osem")})));
    EXPECT_EQ(read_file(path("a.osem")), read_file(path("c.osem")));
    EXPECT_NE(read_file(path("a.osem")), read_file(path("b.osem")));
}

TEST_F(Combine, TheResultKeepsTheLeafRule) {
    const std::vector<std::string> centre = {"--depth", "3", "--leaves", "centre"};
    make_box("a", {0, 0, 0}, {0.5, 1, 1});
    make_box("b", {0.25, 0, 0}, {1, 1, 1});
    EXPECT_EQ(volume({"union", path("a.osem"), path("b.osem")}), "1");
    EXPECT_EQ(info("result")["leaf_rule"], "conservative");
    make_box("a", {0, 0, 0}, {0.5, 1, 1}, centre);
    make_box("b", {0.25, 0, 0}, {1, 1, 1}, centre);
    EXPECT_EQ(volume({"union", path("a.osem"), path("b.osem")}), "1");
    EXPECT_EQ(info("result")["leaf_rule"], "centre");
}

TEST_F(Combine, DifferentLeafRulesAreRefusedNamingBoth) {
    make_box("a", {0, 0, 0}, {0.5, 1, 1});
    make_box("b", {0.25, 0, 0}, {1, 1, 1}, {"--depth", "3", "--leaves", "centre"});
    const auto before = files();
    for (const char* command : {"union", "intersection", "difference", "xor"}) {
        const Ran ran = osem({command, path("a.osem"), path("b.osem"), "-o", path("out.osem")});
        EXPECT_TRUE(failed(ran, 2, path("a.osem") + " has conservative leaves"));
        EXPECT_TRUE(failed(ran, 2, path("b.osem") + " has centre leaves"));
    }
    EXPECT_EQ(files(), before);
}

TEST_F(Combine, DifferentFramesAreRefusedNamingBoth) {
    const std::vector<double> low = {0, 0, 0};
    const std::vector<double> high = {0.5, 0.5, 0.5};
    make_box("a", low, high, {}, "0,0,0,1");
    make_box("b", low, high, {}, "0,-0.1,0,1.0000000000000002");
    make_box("c", low, high, {}, "-0,0,-0,1"); // the frame of a: minus zero is zero
    const auto before = files();
    for (const char* command : {"union", "intersection", "difference", "xor"}) {
        const Ran ran = osem({command, path("a.osem"), path("b.osem"), "-o", path("out.osem")});
        EXPECT_TRUE(failed(ran, 2, path("a.osem") + " covers 0,0,0,1,"));
        EXPECT_TRUE(failed(ran, 2,
                           path("b.osem") +
                               " covers 0,-0.1,0,1.0000000000000002; convert both with the same --frame"));
    }
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(succeeded(osem({"union", path("a.osem"), path("c.osem"), "-o", path("out.osem")})));
}

TEST_F(Combine, LeavesOfABoxInOneOctant) {
    make_box("box", {0.5, 0, 0}, {1, 0.5, 0.5}, {"--depth", "1"});
    const Ran ran = osem({"leaves", path("box.osem")});
    ASSERT_TRUE(succeeded(ran));
    EXPECT_EQ(ran.out, "0 0 0 524288 white\n"
                       "524288 0 0 524288 black\n"
                       "0 524288 0 524288 white\n"
                       "524288 524288 0 524288 white\n"
                       "0 0 524288 524288 white\n"
                       "524288 0 524288 524288 white\n"
                       "0 524288 524288 524288 white\n"
                       "524288 524288 524288 524288 white\n");
}

TEST_F(Combine, AUniformTreeIsOneLeaf) {
    make_box("box", {0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(osem({"leaves", path("box.osem")}).out, "0 0 0 1048576 black\n");
    EXPECT_EQ(volume({"complement", path("box.osem")}), "0");
    EXPECT_EQ(osem({"leaves", path("result.osem")}).out, "0 0 0 1048576 white\n");
}

TEST_F(Combine, LeavesFillTheRootAndAgreeWithInfo) {
    make_box("box", {0.11, 0.22, 0.33}, {0.77, 0.88, 0.99}, {"--depth", "6"});
    const Ran ran = osem({"leaves", path("box.osem")});
    ASSERT_TRUE(succeeded(ran));
    std::map<std::string, std::uint64_t> count;
    std::map<std::string, std::uint64_t> volume_of;
    std::istringstream lines(ran.out);
    std::uint64_t x = 0, y = 0, z = 0, side = 0;
    for (std::string colour; lines >> x >> y >> z >> side >> colour;) {
        ASSERT_EQ((x | y | z) % side, 0U);
        ASSERT_LE(std::max({x, y, z}) + side, 1048576U);
        ++count[colour];
        volume_of[colour] += side * side * side;
    }
    EXPECT_TRUE(lines.eof());
    EXPECT_EQ(count.size(), 3U);
    EXPECT_EQ(volume_of["white"] + volume_of["black"] + volume_of["boundary"], std::uint64_t{1} << 60);
    auto report = info("box");
    for (const char* colour : {"white", "black", "boundary"}) {
        EXPECT_EQ(report[colour], std::to_string(count[colour])) << colour;
    }
    EXPECT_EQ(report["volume_inner"], std::to_string(volume_of["black"]));
    EXPECT_EQ(report["volume_outer"], std::to_string(volume_of["black"] + volume_of["boundary"]));
}

} // namespace

} // namespace osem::tool_test
