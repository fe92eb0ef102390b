// Exit codes, single-line errors, and no file left behind.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <vector>

#include <sys/wait.h>

#include "support.hpp"
#include "tool.hpp"

namespace osem::tool_test {

namespace {

using Names = std::vector<std::string>;

const Names commands = {"check",      "convert",    "union", "intersection", "difference", "xor",   "info",
                        "complement", "leaves",     "image", "slice",        "carray",     "query", "collide",
                        "measure",    "components", "mesh",  "transform",    "coarsen",    "csg"};

TEST_F(Tool, HelpListsEveryCommandAndEachHasHelp) {
    const Ran ran = osem({"--help"});
    ASSERT_TRUE(succeeded(ran));
    for (const std::string& command : commands) {
        EXPECT_NE(ran.out.find("\n  " + command + " "), std::string::npos) << command;
        const Ran help = osem({command, "--help"});
        EXPECT_TRUE(succeeded(help)) << command;
        EXPECT_NE(help.out.find("Exit codes: 0 done; 1 wrong usage; 2 "), std::string::npos) << command;
    }
    EXPECT_NE(osem({"query", "box", "--help"}).out.find("Exit codes"), std::string::npos);
}

TEST_F(Tool, AWordThatIsNoCommandIsNamed) {
    EXPECT_EQ(osem({"frob"}).err, "osem: frob is no command of osem; osem --help lists them\n");
    EXPECT_EQ(osem({"query", "a.osem", "frob"}).err,
              "osem: frob is no command of osem query; osem query --help lists them\n");
    EXPECT_EQ(osem({}).err, "osem: osem wants a command; osem --help lists them\n");
    EXPECT_TRUE(failed(osem({"frob"}), 1, "frob"));
}

TEST_F(Tool, WrongUsageExitsWithOne) {
    EXPECT_TRUE(failed(osem({}), 1, ""));
    EXPECT_TRUE(failed(osem({"melt"}), 1, ""));
    for (const std::string& command : commands) EXPECT_TRUE(failed(osem({command}), 1, "")) << command;
    EXPECT_TRUE(failed(osem({"info", "a.osem", "b.osem"}), 1, "b.osem"));
    EXPECT_TRUE(failed(osem({"info", "a.osem", "--louder"}), 1, "--louder"));
    EXPECT_TRUE(failed(osem({"union", "a.osem", "-o", "c.osem"}), 1, "B"));
}

TEST_F(Tool, OptionsOutOfRangeAreWrongUsage) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const Names before = files();
    const auto convert = [&](const Names& options) {
        Names line = {"convert", path("box.off"), "-o", path("out.osem")};
        line.insert(line.end(), options.begin(), options.end());
        return osem(line);
    };
    EXPECT_TRUE(failed(convert({"--depth", "0"}), 1, "--depth"));
    EXPECT_TRUE(failed(convert({"--depth", "21"}), 1, "--depth"));
    EXPECT_TRUE(failed(convert({"--depth", "deep"}), 1, "--depth"));
    EXPECT_TRUE(failed(convert({"--depth", "20", "--leaves", "centre"}), 1, "--depth"));
    EXPECT_TRUE(failed(convert({"--leaves", "round"}), 1, "--leaves"));
    EXPECT_TRUE(failed(convert({"--winding", "even"}), 1, "--winding"));
    for (const char* frame : {"", "0,0,0", "0,0,0,1,2", "0,0,0,0", "0,0,0,-1", "0,0,0,inf", "nan,0,0,1",
                              "0,0,0,1x", "0 0 0 1", "0,0,0,1e999", "1e308,0,0,1.7e308"}) {
        EXPECT_TRUE(failed(convert({"--frame", frame}), 1, "--frame")) << frame;
    }
    EXPECT_TRUE(
        failed(osem({"image", path("box.osem"), "-o", path("o.png"), "--view", "behind"}), 1, "--view"));
    EXPECT_TRUE(
        failed(osem({"image", path("box.osem"), "-o", path("o.png"), "--view", "0,91"}), 1, "--view"));
    EXPECT_TRUE(failed(osem({"image", path("box.osem"), "-o", path("o.png"), "--size", "15"}), 1, "--size"));
    EXPECT_TRUE(failed(osem({"slice", path("box.osem"), "-o", path("o.png"), "--axis", "w", "--at", "0"}), 1,
                       "--axis"));
    EXPECT_TRUE(failed(osem({"slice", path("box.osem"), "-o", path("o.png"), "--axis", "x", "--at", "mid"}),
                       1, "--at"));
    EXPECT_EQ(files(), before);
}

TEST_F(Tool, MissingInputExitsWithTwoAndLeavesNoFile) {
    const std::string none = path("none.osem");
    const std::string out = path("out.png");
    const std::string tree = path("out.osem");
    for (const Names& line :
         {Names{"check", path("none.off")}, Names{"convert", path("none.off"), "-o", tree},
          Names{"union", none, none, "-o", tree}, Names{"complement", none, "-o", tree}, Names{"info", none},
          Names{"leaves", none}, Names{"image", none, "-o", out},
          Names{"slice", none, "-o", out, "--axis", "x", "--at", "0"}, Names{"carray", none, "-o", out}}) {
        EXPECT_TRUE(failed(osem(line), 2, "none.")) << line[0];
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(Tool, OutputInAMissingFolderIsRefused) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const Names before = files();
    const std::string in = path("box.osem");
    const std::string out = path("nowhere/out.png");
    const std::string tree = path("nowhere/out.osem");
    for (const Names& line :
         {Names{"convert", path("box.off"), "-o", tree}, Names{"union", in, in, "-o", tree},
          Names{"convert", path("box.off"), "-o", path("good.osem"), "--quantized", out},
          Names{"complement", in, "-o", tree}, Names{"image", in, "-o", out, "--size", "16"},
          Names{"slice", in, "-o", out, "--axis", "x", "--at", "0"}, Names{"carray", in, "-o", out}}) {
        EXPECT_TRUE(failed(osem(line), 2, "nowhere/out")) << line[0];
    }
    EXPECT_TRUE(failed(osem({"complement", in, "-o", path(".")}), 2, "directory"));
    EXPECT_EQ(files(), before);
}

TEST_F(Tool, AFailureKeepsTheFileThatWasThere) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    write_file(path("open.off"), "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n");
    write_file(path("out.osem"), "precious");
    const Names before = files();
    EXPECT_TRUE(failed(osem({"check", path("open.off")}), 2, "open.off"));
    EXPECT_TRUE(failed(osem({"convert", path("open.off"), "-o", path("out.osem")}), 2, "open.off"));
    EXPECT_TRUE(
        failed(osem({"union", path("box.osem"), path("open.off"), "-o", path("out.osem")}), 2, "open.off"));
    EXPECT_EQ(read_file(path("out.osem")), "precious");
    EXPECT_EQ(files(), before);
}

TEST_F(Tool, AnOutputMayReplaceAnOperand) {
    make_box("a", {0, 0, 0}, {0.5, 1, 1});
    make_box("b", {0, 0, 0}, {0.5, 1, 1});
    ASSERT_TRUE(succeeded(osem({"union", path("a.osem"), path("b.osem"), "-o", path("a.osem")})));
    EXPECT_EQ(read_file(path("a.osem")), read_file(path("b.osem")));
}

TEST_F(Tool, TheInputIsNotOverwritten) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    std::filesystem::create_symlink(path("box.off"), path("link.off"));
    std::filesystem::create_hard_link(path("box.off"), path("link.osem"));
    const Names before = files();
    const std::string mesh = read_file(path("box.off"));
    const std::string tree = read_file(path("box.osem"));
    const std::string in = path("box.osem");
    const std::string new_tree = path("new.osem");
    for (const std::string& same : {path("link.osem"), path("./link.osem")}) {
        EXPECT_TRUE(failed(osem({"convert", path("box.off"), "-o", same}), 1, "--output: the same file"));
    }
    for (const std::string& same : {path("box.off"), path("./box.off"), path("link.off")}) {
        EXPECT_TRUE(failed(osem({"convert", path("box.off"), "-o", new_tree, "--quantized", same}), 1,
                           "--quantized: the same file"));
    }
    EXPECT_TRUE(failed(osem({"convert", path("box.off"), "-o", new_tree, "--quantized", path("./new.osem")}),
                       1, "--quantized: the same file"));
    EXPECT_TRUE(failed(osem({"slice", in, "-o", in, "--axis", "x", "--at", "0", "--runs"}), 1,
                       "--output: the same file"));
    EXPECT_EQ(read_file(path("box.off")), mesh);
    EXPECT_EQ(read_file(path("box.osem")), tree);
    EXPECT_EQ(files(), before);
}

TEST_F(Tool, AnEmptyOutputNameIsWrongUsage) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const std::string in = path("box.osem");
    for (const Names& line :
         {Names{"convert", path("box.off"), "-o", ""}, Names{"union", in, in, "-o", ""},
          Names{"convert", path("box.off"), "-o", path("new.osem"), "--quantized", ""},
          Names{"complement", in, "-o", ""}, Names{"image", in, "-o", ""},
          Names{"slice", in, "-o", "", "--axis", "x", "--at", "0"}, Names{"carray", in, "-o", ""}}) {
        EXPECT_TRUE(failed(osem(line), 1, "the name of the file to write is empty")) << line[0];
        Names dashed = line;
        std::replace(dashed.begin(), dashed.end(), std::string(), std::string("-"));
        EXPECT_TRUE(failed(osem(dashed), 1, "/dev/stdout")) << line[0];
        EXPECT_FALSE(std::filesystem::exists("-")) << line[0];
    }
}

TEST_F(Tool, ANameWithALineBreakIsReportedOnOneLine) {
    EXPECT_TRUE(failed(osem({"info", path("two\nlines.osem")}), 2, "two lines.osem"));
}

// A stream that takes nothing, as a full disk or a closed pipe.
class Refusing : public std::streambuf {};

TEST_F(Tool, OutputThatCannotBeWrittenIsAnError) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const std::string in = path("box.osem");
    const std::string mesh = path("box.off");
    const std::string tree = path("out.osem");
    const std::string surface = path("out.off");
    write_file(tree, "as before");
    const Names before = files();
    const Names lines[] = {{"leaves", in},
                           {"info", in},
                           {"convert", mesh, "-o", tree, "--stats", "--quantized", surface},
                           {"convert", mesh, "-o", tree, "--fit", "100"},
                           {"csg", "a", "a=" + mesh, "-o", tree, "--stats"},
                           {"mesh", in, "-o", surface},
                           {"coarsen", in, "-o", tree, "--nodes", "2"},
                           {"coarsen", in, "-o", tree, "--depth", "1"},
                           {"transform", in, "-o", tree, "--up", "1", "--at", "0,0,0"}};
    for (const Names& line : lines) {
        Refusing nothing;
        std::ostream out(&nothing);
        std::ostringstream err;
        std::vector<const char*> argv = {"osem"};
        for (const std::string& word : line) argv.push_back(word.c_str());
        EXPECT_EQ(host::run(static_cast<int>(argv.size()), argv.data(), out, err), 2);
        EXPECT_EQ(err.str(), "osem: standard output: cannot be written\n") << line[0];
        EXPECT_EQ(files(), before) << line[0];
        EXPECT_EQ(read_file(tree), "as before") << line[0];
    }
}

TEST_F(Tool, AFileThatIsReplacedKeepsItsPermissions) {
    namespace fs = std::filesystem;
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const fs::perms owner_alone = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(path("box.osem"), owner_alone);
    ASSERT_TRUE(succeeded(osem({"complement", path("box.osem"), "-o", path("box.osem")})));
    EXPECT_EQ(fs::status(path("box.osem")).permissions(), owner_alone);
}

TEST_F(Tool, ALinkToNothingIsNoOutput) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    std::filesystem::create_symlink(path("nowhere"), path("link.osem"));
    const Names before = files();
    EXPECT_TRUE(failed(osem({"complement", path("box.osem"), "-o", path("link.osem")}), 2,
                       "link.osem: cannot be written: it is a link to a file that is not there"));
    EXPECT_EQ(files(), before);
}

TEST_F(Tool, AnOctreeIsNotWrittenOverAMesh) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const std::string tree = path("box.osem");
    for (const char* name : {"out.off", "out.STL", "out.obj", "out.poly", "out.png"}) {
        for (const Names& line :
             {Names{"convert", path("box.off")}, Names{"union", tree, tree}, Names{"complement", tree},
              Names{"csg", "a", "a=" + tree}, Names{"coarsen", tree, "--depth", "1"},
              Names{"transform", tree, "--up", "1"}}) {
            Names whole = line;
            whole.insert(whole.end(), {"-o", path(name)});
            EXPECT_TRUE(failed(osem(whole), 1, "an octree is written")) << line[0];
        }
    }
}

TEST_F(Tool, TheExecutableExitsAsTheFunctionDoes) {
    const auto exit_code = [](const std::string& arguments) {
        const int status = std::system(("'" OSEM_TOOL_PATH "' " + arguments + " >/dev/null 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    };
    EXPECT_EQ(exit_code("--help"), 0);
    EXPECT_EQ(exit_code("melt"), 1);
    EXPECT_EQ(exit_code("info '" + path("none.osem") + "'"), 2);
}

TEST_F(Tool, AnOctreeGoesThroughAPipe) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    ASSERT_TRUE(succeeded(osem({"complement", path("box.osem"), "-o", path("out.osem")})));
    const std::string line = "'" OSEM_TOOL_PATH "' complement '" + path("box.osem") +
                             "' -o /dev/stdout | cat > '" + path("piped.osem") + "'";
    ASSERT_EQ(std::system(line.c_str()), 0);
    EXPECT_EQ(read_file(path("piped.osem")), read_file(path("out.osem")));
}

} // namespace

} // namespace osem::tool_test
