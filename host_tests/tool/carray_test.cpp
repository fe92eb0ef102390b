// Headers of constants: what a compiler makes of them is the file they were written from.
#include <cstdlib>
#include <filesystem>
#include <locale>

#include <sys/wait.h>

#include "files/identifier.hpp"
#include "support.hpp"

namespace osem::tool_test {

namespace {

using Names = std::vector<std::string>;

const std::string warnings = " -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror";
const std::string bracket = OSEM_SAMPLES_DIR "/bracket.poly";

// A wedge of triangles.
const char* const wedge_off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

class Carray : public Tool {
  protected:
    int run(const std::string& command) const {
        const int status = std::system((command + " > '" + path("log") + "' 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    // The project's compiler on files given by name; what it says is in the file "log".
    int compile(const std::string& arguments, int index_bits) const {
        return run(
            "'" OSEM_TEST_COMPILER "' -std=c++17 -DOSEM_NODE_INDEX_BITS=" + std::to_string(index_bits) +
            " -I'" OSEM_SOURCE_DIR "/kernel/include' -I'" OSEM_SOURCE_DIR "/kernel/src' -I'" + path("") +
            "' " + arguments);
    }

    // Whether a header compiles without a warning.
    bool is_header(const std::string& name, int index_bits = 32) const {
        return compile(warnings + " -fsyntax-only -x c++ '" + path(name) + "'", index_bits) == 0;
    }

    // osem carray; the header's text.
    std::string header(const std::string& input, const Names& options = {}) const {
        Names line = {"carray", input, "-o", path("header.hpp")};
        line.insert(line.end(), options.begin(), options.end());
        EXPECT_TRUE(succeeded(osem(line)));
        return read_file(path("header.hpp"));
    }
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Carray, AProgramFindsWhatTheFilesHold) {
    const std::string tree = path("part.osem");
    write_file(path("wedge.off"), wedge_off);
    make_box("full", {0, 0, 0}, {1, 1, 1});
    for (const Names& line :
         {Names{"convert", bracket, "--frame", "0,0,0,128", "--depth", "5", "-o", tree},
          Names{"carray", tree, "-o", path("part_tree.hpp")},
          Names{"carray", bracket, "--frame", "0,0,0,128", "--name", "part", "-o", path("part_solid.hpp")},
          Names{"carray", path("wedge.off"), "-o", path("wedge_solid.hpp")},
          Names{"carray", path("full.osem"), "-o", path("full_tree.hpp")}}) {
        ASSERT_TRUE(succeeded(osem(line))) << line[0];
    }
    std::string sources = " '" OSEM_SOURCE_DIR "/host_tests/tool/carray_program.cpp'";
    for (const char* folder : {"tree", "stream", "geometry", "solid", "classify", "convert", "query"}) {
        sources += std::string(" '" OSEM_SOURCE_DIR "'/kernel/src/") + folder + "/*.cpp";
    }
    for (const int index_bits : {32, 16}) {
        ASSERT_EQ(compile(warnings + sources + " -o '" + path("program") + "'", index_bits), 0)
            << index_bits << "-bit indices: " << read_file(path("log"));
        EXPECT_EQ(run("'" + path("program") + "' '" + tree + "'"), 0) << index_bits << "-bit indices";
    }
    // The program does look: another tree is not its own.
    EXPECT_EQ(run("'" + path("program") + "' '" + path("full.osem") + "'"), 2);
}

TEST_F(Carray, TheCommentSaysWhatItIs) {
    ASSERT_TRUE(succeeded(osem({"convert", bracket, "--frame", "-0.5,0,1,128", "--depth", "5", "--leaves",
                                "centre", "-o", path("part.osem")})));
    const std::string tree = header(path("part.osem"));
    const std::string nodes = info("part")["nodes"];
    for (const std::string& part :
         {std::string("\"part.osem\""), std::string("depth       5\n"), std::string("leaves      centre\n"),
          std::string("-0.5,0,1,128 (X,Y,Z,SIDE)"), std::string("{{-0.5 * 2^f, 0, 1 * 2^f}, 13 - f}"),
          std::to_string(std::stoul(nodes) - 1) + " and the top\n",
          std::to_string(6 * (std::stoul(nodes) - 1)) + " bytes of nodes"}) {
        EXPECT_TRUE(holds(tree, part)) << part;
    }
    const std::string solid = header(bracket, {"--frame", "0,0,0,130", "--winding", "positive"});
    EXPECT_TRUE(holds(solid, "\"bracket.poly\""));
    EXPECT_TRUE(holds(solid, "faces       " + table(osem({"check", bracket}).out)["faces"] + "\n"));
    EXPECT_TRUE(holds(solid, "WindingRule::positive;"));
    EXPECT_FALSE(holds(solid, "osem::Frame")) << "a side of 130 is not a power of two";
}

// Groups digits, as many a locale does.
struct Grouping : std::numpunct<char> {
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
};

TEST_F(Carray, TheTextDependsOnTheFileAlone) {
    make_box("box", {0.11, 0.22, 0.33}, {0.77, 0.88, 0.99}, {"--depth", "6"});
    const std::string tree = header(path("box.osem"));
    const std::string solid = header(path("box.off"));
    EXPECT_FALSE(holds(tree + solid, path(""))) << "names the file without its folder";
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Grouping));
    EXPECT_EQ(header(path("box.osem")), tree);
    EXPECT_EQ(header(path("box.off")), solid);
    std::locale::global(before);
    for (const std::string& text : {tree, solid}) {
        std::size_t longest = 0;
        for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
            longest = std::max(longest, end - at);
        }
        EXPECT_LE(longest, 110U);
    }
}

TEST_F(Carray, TooManyNodesForTheIndicesDoNotCompile) {
    make_box("box", {0.14, 0.14, 0.14}, {0.86, 0.86, 0.86}, {"--depth", "8"});
    ASSERT_GT(std::stoul(info("box")["nodes"]), 65536U);
    header(path("box.osem"));
    EXPECT_TRUE(is_header("header.hpp", 32)) << read_file(path("log"));
    EXPECT_FALSE(is_header("header.hpp", 16));
    EXPECT_TRUE(holds(read_file(path("log")), "box has more nodes than OSEM_NODE_INDEX_BITS can count"));
}

TEST_F(Carray, NamesComeFromTheFileOrTheCommandLine) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    const std::string in = path("box.osem");
    EXPECT_TRUE(holds(header(in), "\nnamespace box {\n"));
    EXPECT_TRUE(holds(header(in, {"--name", "keep_out2"}), "\nnamespace keep_out2 {\n"));
    const Names before = files();
    for (const char* name :
         {"", "2x", "a-b", "a b", "a__b", "_a", "int", "xor", "osem", "caf\xc3\xa9", "a;"}) {
        EXPECT_TRUE(failed(osem({"carray", in, "-o", path("out.hpp"), "--name", name}), 1, "--name")) << name;
    }
    EXPECT_EQ(files(), before);
}

TEST_F(Carray, AnyFileNameGivesAHeader) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    for (const char* name :
         {"two\nlines.osem", "back\\.osem", "quo\"te.OSEM", "*/.osem", "int.osem", "3d part.osem"}) {
        std::string file = name;
        for (char& c : file) c = c == '/' ? '|' : c;
        std::filesystem::copy(path("box.osem"), path(file));
        header(path(file));
        EXPECT_TRUE(is_header("header.hpp")) << file << read_file(path("log"));
    }
}

TEST_F(Carray, BadInputLeavesNoHeader) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    std::string damaged = read_file(path("box.osem"));
    damaged[60] = static_cast<char>(damaged[60] ^ 1);
    write_file(path("bad.osem"), damaged);
    write_file(path("open.off"), "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n");
    write_file(path("text.txt"), "no mesh");
    const Names before = files();
    const auto refused = [&](const Names& options, int code, const std::string& part) {
        Names line = {"carray", "-o", path("out.hpp")};
        line.insert(line.end(), options.begin(), options.end());
        return failed(osem(line), code, part);
    };
    EXPECT_TRUE(refused({path("bad.osem")}, 2, "bad.osem"));
    EXPECT_TRUE(refused({path("open.off")}, 2, "open.off"));
    EXPECT_TRUE(refused({path("text.txt")}, 2, "text.txt"));
    EXPECT_TRUE(refused({path("none.osem")}, 2, "none.osem"));
    EXPECT_TRUE(refused({path("none.off")}, 2, "none.off"));
    EXPECT_TRUE(refused({path("box.off"), "--frame", "0,0,0,0.5"}, 2, "box.off"));
    EXPECT_TRUE(refused({path("box.osem"), "--frame", "0,0,0,1"}, 1, "--frame"));
    EXPECT_TRUE(refused({path("box.osem"), "--winding", "odd"}, 1, "--winding"));
    EXPECT_TRUE(failed(osem({"carray", path("box.osem"), "-o", path("./box.osem")}), 1, "the same file"));
    EXPECT_EQ(files(), before);
}

TEST(Identifier, KeywordsAreTaken) {
    for (const char* name :
         {"alignas", "auto", "class", "co_await", "int", "main", "new", "osem", "std", "xor_eq"}) {
        EXPECT_FALSE(host::identifier_fault(name).empty()) << name;
        EXPECT_TRUE(host::identifier_fault(std::string(name) + "s").empty()) << name;
    }
}

TEST(Identifier, AnyFileNameGivesAName) {
    EXPECT_EQ(host::identifier_of("folder.d/keep-out zone.osem"), "keep_out_zone");
    EXPECT_EQ(host::identifier_of("a__b--c_.osem"), "a_b_c_");
    EXPECT_EQ(host::identifier_of("3d.osem"), "shape_3d");
    EXPECT_EQ(host::identifier_of("union.osem"), "shape_union");
    EXPECT_EQ(host::identifier_of("_hidden.off"), "hidden");
    EXPECT_EQ(host::identifier_of("\xc3\xa9.off"), "shape_");
    for (const char* path : {"", "/", ".", "..", ".osem", "--.osem"}) {
        EXPECT_TRUE(host::identifier_fault(host::identifier_of(path)).empty()) << path;
    }
}

} // namespace

} // namespace osem::tool_test
