// osem csg: expressions over mesh files and octree files.
#include "support.hpp"

namespace osem::tool_test {

namespace {

class Csg : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        make_box("a", {0, 0, 0}, {0.5, 1, 1});
        make_box("b", {0.25, 0, 0}, {1, 1, 1});
        make_box("c", {0, 0, 0}, {1, 1, 0.5});
    }

    Ran csg(const std::string& expression, const std::vector<std::string>& more = {}) {
        std::vector<std::string> line = {
            "csg", expression,         "a=" + path("a.off"), "b=" + path("b.osem"), "c=" + path("c.off"),
            "-o",  path("result.osem")};
        line.insert(line.end(), more.begin(), more.end());
        return osem(line);
    }

    std::string volume(const std::string& expression) {
        EXPECT_TRUE(succeeded(csg(expression)));
        return info("result")["volume_inner_world"];
    }
};

// The boxes cover 1/2, 3/4 and 1/2 of the root; a and b overlap in 1/4, and c halves everything.
TEST_F(Csg, VolumesOfBoxes) {
    EXPECT_EQ(volume("(a - b) & c"), "0.125");
    EXPECT_EQ(volume("a - b & c"), "0.375"); // & binds more tightly
    EXPECT_EQ(volume("a - b - c"), "0.125");
    EXPECT_EQ(volume("a - (b - c)"), "0.375");
    EXPECT_EQ(volume("!(a | b) + c"), "0.5");
    EXPECT_EQ(volume("a ^ b ^ ~c"), "0.5");
    EXPECT_EQ(volume("a & b & c | a & !b & c"), "0.25");
}

TEST_F(Csg, WhatIsTakenFromItselfIsEmptyInOneVisit) {
    const Ran ran = csg("(a - a) | b & !b | c - c", {"--stats"});
    ASSERT_TRUE(succeeded(ran));
    EXPECT_EQ(table(ran.out)["octants"], "1");
    EXPECT_EQ(info("result")["volume_outer"], "0");
}

TEST_F(Csg, IsWhatConvertingAndCombiningGives) {
    make_box("a", {0.11, 0.2, 0.3}, {0.7, 0.83, 0.9}, {"--depth", "6"});
    make_box("b", {0.33, 0.1, 0.4}, {0.9, 0.72, 0.77}, {"--depth", "6"});
    make_box("c", {0.05, 0.05, 0.05}, {0.5, 0.5, 0.5}, {"--depth", "6"});
    ASSERT_TRUE(
        succeeded(osem({"difference", path("a.osem"), path("b.osem"), "-o", path("difference.osem")})));
    ASSERT_TRUE(
        succeeded(osem({"union", path("difference.osem"), path("c.osem"), "-o", path("materialised.osem")})));
    ASSERT_TRUE(succeeded(csg("a - b | c")));
    EXPECT_EQ(read_file(path("result.osem")), read_file(path("materialised.osem")));
}

TEST_F(Csg, WrongExpressionsAreRefusedWithTheColumn) {
    const auto before = files();
    EXPECT_TRUE(failed(csg("a - b - "), 1, "column 9: expected a name"));
    EXPECT_TRUE(failed(csg("(a - b & c"), 1, "column 11: expected )"));
    EXPECT_TRUE(failed(csg("a - b) & c"), 1, "column 6: there is nothing to close"));
    EXPECT_TRUE(failed(csg("a b c"), 1, "column 3: expected an operator"));
    EXPECT_TRUE(failed(csg("a - b - d"), 1, "column 9: no file is given for d"));
    EXPECT_TRUE(failed(csg("a - b"), 1, "does not use c"));
    EXPECT_TRUE(failed(csg(std::string(100, '!') + "a - b - c"), 1, "nested too deeply"));
    std::string long_sum = "a - b - c";
    for (int i = 0; i < 40; ++i) long_sum += " + a";
    EXPECT_TRUE(failed(csg(long_sum), 1, "too large"));
    EXPECT_EQ(files(), before);
}

TEST_F(Csg, WrongBindingsAreRefused) {
    const std::string out = path("result.osem");
    for (const char* binding : {"a", "a=", "=file.off", "1a=file.off"}) {
        EXPECT_TRUE(failed(osem({"csg", "a", binding, "-o", out}), 1, "expected a name, = and a file"));
    }
    EXPECT_TRUE(failed(osem({"csg", "a", "a=x.off", "a=y.off", "-o", out}), 1, "a is given twice"));
    EXPECT_TRUE(failed(osem({"csg", "a", "a=" + path("none.off"), "-o", out}), 2, "none.off"));
    EXPECT_TRUE(failed(osem({"csg", "a", "a=" + path("a.off"), "-o", path("a.off")}), 1, "--output"));
}

TEST_F(Csg, FramesDepthsAndLeafRulesHaveToAgreeWithTheOctreeFiles) {
    EXPECT_TRUE(failed(csg("a - b - c", {"--frame", "0,0,0,2"}), 2, "the frames differ"));
    EXPECT_TRUE(failed(csg("a - b - c", {"--depth", "2"}), 2, "has a depth of 3"));
    EXPECT_TRUE(failed(csg("a - b - c", {"--leaves", "centre"}), 2, "has conservative leaves"));
    ASSERT_TRUE(succeeded(csg("a - b - c", {"--depth", "5"})));
    EXPECT_EQ(info("result")["depth"], "5");
    EXPECT_EQ(info("result")["frame"], "0,0,0,1");
}

} // namespace

} // namespace osem::tool_test
