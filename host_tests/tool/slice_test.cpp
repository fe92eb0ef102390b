// osem slice beside single pictures: stacks and runs.
#include <filesystem>
#include <sstream>

#include "support.hpp"

namespace osem::tool_test {

namespace {

class Slices : public Tool {
  protected:
    // A box from 1/4 to 3/4 along x, from 0 to 1/2 along y and from 1/8 to 3/8 along z, at depth 3.
    void SetUp() override {
        Tool::SetUp();
        make_box("box", {0.25, 0, 0.125}, {0.75, 0.5, 0.375});
    }
    Ran slice(const std::vector<std::string>& arguments) const {
        std::vector<std::string> all = {"slice", path("box.osem"), "--axis", "z"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return osem(all);
    }
};

std::string rows_text(int layer) {
    std::ostringstream text;
    for (int row = 0; row < 4; ++row) text << layer << ' ' << row << " 2 4 black\n";
    return text.str();
}

TEST_F(Slices, RunsArePrintedAsText) {
    const Ran one = slice({"--at", "0.2", "--runs"});
    ASSERT_TRUE(succeeded(one));
    EXPECT_EQ(one.out, rows_text(1));
    const Ran none = slice({"--at", "0.5", "--runs"});
    ASSERT_TRUE(succeeded(none));
    EXPECT_EQ(none.out, "");
    const Ran all = slice({"--stack", "--runs", "-o", path("runs.txt")});
    ASSERT_TRUE(succeeded(all));
    EXPECT_EQ(all.out, "");
    EXPECT_EQ(read_file(path("runs.txt")), rows_text(1) + rows_text(2));
}

// At level 2 pixels 1 and 2 of the row lie in the box; at level 1 each is half in it.
TEST_F(Slices, ALevelMakesPixelsCoarserAndTellsWhatIsMixed) {
    EXPECT_EQ(slice({"--at", "0.2", "--runs", "--level", "2"}).out, "0 0 1 2 black\n0 1 1 2 black\n");
    EXPECT_EQ(slice({"--at", "0.2", "--runs", "--level", "1"}).out, "0 0 0 2 boundary\n");
    EXPECT_EQ(slice({"--at", "0.2", "--runs", "--level", "0"}).out, "0 0 0 1 boundary\n");
    EXPECT_TRUE(failed(slice({"--at", "0.2", "--runs", "--level", "4"}), 2, "deeper"));
}

TEST_F(Slices, AStackIsTheSinglePicturesOfItsLayers) {
    ASSERT_TRUE(succeeded(slice({"--stack", "-o", path("all")})));
    for (int layer = 0; layer < 8; ++layer) {
        const std::string at = std::to_string(layer * 0.125 + 0.0625);
        ASSERT_TRUE(succeeded(slice({"--at", at, "-o", path("one.png")})));
        const std::string name = path("all/000" + std::to_string(layer) + ".png");
        EXPECT_EQ(read_file(name), read_file(path("one.png"))) << layer;
    }
    EXPECT_FALSE(std::filesystem::exists(path("all/0008.png")));
}

TEST_F(Slices, AStackMayBeAPartAndHaveNamesOfItsOwn) {
    const auto before = files();
    ASSERT_TRUE(succeeded(
        slice({"--stack", "--from", "0.125", "--to", "0.9", "--every", "3", "-o", path("part%02d_z.png")})));
    std::vector<std::string> expected = before;
    for (const char* name : {"part01_z.png", "part04_z.png", "part07_z.png"}) expected.emplace_back(name);
    EXPECT_EQ(files(), expected);
}

TEST_F(Slices, WhatMakesNoSenseIsRefused) {
    const auto before = files();
    const std::string out = path("o.png");
    EXPECT_TRUE(failed(slice({"-o", out}), 1, "either --at or --stack"));
    EXPECT_TRUE(failed(slice({"--at", "0", "--stack", "-o", out}), 1, "either --at or --stack"));
    EXPECT_TRUE(failed(slice({"--at", "0", "--every", "2", "-o", out}), 1, "--stack"));
    EXPECT_TRUE(failed(slice({"--at", "0"}), 1, "--output"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", path("a%sb.png")}), 1, "%0Nd"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", path("a%d%d.png")}), 1, "%0Nd"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", path("a%")}), 1, "%0Nd"));
    EXPECT_TRUE(failed(slice({"--stack", "--from", "2", "-o", path("a%d.png")}), 2, "--from"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", path("box.off")}), 2, "box.off"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", out}), 1, "expected a directory"));
    EXPECT_TRUE(failed(slice({"--stack", "-o", path("a%d.jpg")}), 1, "ends in .png"));
    EXPECT_TRUE(failed(slice({"--at", "0", "-o", path("o.jpg")}), 1, "ends in .png"));
    EXPECT_EQ(files(), before);
}

} // namespace

} // namespace osem::tool_test
