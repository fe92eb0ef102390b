// Files and arguments made to do harm: what they announce is not trusted with memory, what they name is not
// opened, and no input is written over.
#include "support.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <sys/stat.h>
#include <sys/wait.h>

namespace osem::tool_test {

namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool limit_memory = false; // the sanitizer reserves address space without end
#elif defined(__has_feature)
constexpr bool limit_memory = !__has_feature(address_sanitizer);
#else
constexpr bool limit_memory = true;
#endif

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr std::size_t program_itself = 64 * megabyte; // address space, before there is any input
constexpr std::size_t bytes_a_byte = 40;              // of address space for a byte of input, at most

class Hostile : public Tool {
  protected:
    /// Runs the executable on a file of these bytes, with address space in proportion to them.
    Ran run_on(const std::string& command, const std::string& name, const std::string& bytes) const {
        write_file(path(name), bytes);
        const std::size_t space = program_itself + bytes_a_byte * bytes.size();
        const std::string limit = limit_memory ? "ulimit -v " + std::to_string(space / 1024) + "; " : "";
        const std::string line = limit + "exec timeout 60 '" OSEM_TOOL_PATH "' " + command + " '" +
                                 path(name) + "' > '" + path("out") + "' 2> '" + path("err") + "'";
        const int status = std::system(line.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(path("out")), read_file(path("err"))};
    }
    /// One short line that names what is wrong.
    void expect_refused(const std::string& name, const std::string& bytes, const std::string& part) const {
        const Ran ran = run_on("check", name, bytes);
        EXPECT_TRUE(failed(ran, 2, part)) << name;
        EXPECT_LT(ran.err.size(), path(name).size() + 300) << name;
    }
};

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    all.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

const std::string off_triangle = "0 0 0\n1 0 0\n0 1 0\n";
const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string poly_triangle = "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";

// A facet of polygons each of which lies in all those before it.
std::string nested_squares(int count) {
    std::string nodes = std::to_string(4 * count) + " 3 0 0\n";
    std::string polygons = "1 0\n" + std::to_string(count) + " 0\n";
    for (int i = 0; i < count; ++i) {
        const std::string far = std::to_string(count - i);
        const std::string corners[] = {'-' + far + " -" + far, far + " -" + far, far + ' ' + far,
                                       '-' + far + ' ' + far};
        polygons += '4';
        for (int k = 0; k < 4; ++k) {
            const std::string number = std::to_string(4 * i + k);
            nodes += number + ' ' + corners[k] + " 0\n";
            polygons += ' ' + number;
        }
        polygons += '\n';
    }
    return nodes + polygons;
}

TEST_F(Hostile, AnnouncedNumbersAreNotTrustedWithMemory) {
    const std::string many = "4294967295";
    const std::string part = "more than the rest of the file can hold";
    expect_refused("vertices.off", "OFF\n" + many + " 1 0\n" + off_triangle, part);
    expect_refused("faces.off", "OFF\n3 " + many + " 0\n" + off_triangle, part);
    expect_refused("corners.off", "OFF\n3 1 0\n" + off_triangle + many + " 0 1 2\n", part);
    expect_refused("nodes.poly", many + " 3 0 0\n1 0 0 0\n", part);
    expect_refused("facets.poly", poly_triangle + many + " 0\n1\n3 1 2 3\n", part);
    expect_refused("polygons.poly", poly_triangle + "1 0\n" + many + "\n3 1 2 3\n", part);
    expect_refused("holes.poly", poly_triangle + "1 0\n1 " + many + "\n3 1 2 3\n", part);
    expect_refused("corners.poly", poly_triangle + "1 0\n1\n" + many + " 1 2 3\n", part);
    expect_refused("volume.poly", poly_triangle + "1 0\n1\n3 1 2 3\n" + many + "\n", part);
    const std::string stl = std::string(80, '\0') + "\xff\xff\xff\xff" + std::string(50, '\0');
    expect_refused("triangles.stl", stl, "announces 4294967295 triangles");
    expect_refused("twice.stl", "solid" + stl.substr(5), "announces 4294967295 triangles");
    // Numbers past 32 and 64 bits
    for (const char* number : {"4294967296", "18446744073709551617", "99999999999999999999999"}) {
        expect_refused("past.off", std::string("OFF\n") + number + " 1 0\n", "too great");
        expect_refused("past.poly", std::string(number) + " 3 0 0\n", "too great");
    }
}

TEST_F(Hostile, IndicesThatPointAnywhereAreRefused) {
    for (const char* index : {"3", "4294967295", "-1", "-2147483648", "1e9", "0x1"}) {
        const std::string face = std::string("3 0 1 ") + index + "\n";
        EXPECT_EQ(run_on("check", "index.off", "OFF\n3 1 0\n" + off_triangle + face).code, 2) << index;
        EXPECT_EQ(run_on("check", "index.poly", poly_triangle + "1 0\n1\n3 1 2 " + index + "9\n").code, 2);
    }
    for (const char* index : {"0", "4", "-4", "-9223372036854775808", "9223372036854775807",
                              "99999999999999999999", "1/", "1//", "1/1/1/1", "-", "+1"}) {
        EXPECT_EQ(run_on("check", "index.obj", obj_triangle + "f 1 2 " + index + "\n").code, 2) << index;
    }
}

TEST_F(Hostile, MemoryIsInProportionToTheFile) {
    constexpr std::size_t size = 4 * megabyte;
    expect_refused("corner.obj", obj_triangle + "f 1 2 " + std::string(size, '9') + "\n", "no vertex index");
    expect_refused("number.off", "OFF\n1 1 0\n" + std::string(size, '1') + "e999 0 0\n",
                   "is not a finite number");
    expect_refused("word.off", std::string(size, 'O') + "\n", "begins with");
    expect_refused("word.stl", "solid\n" + std::string(size, 'f') + "\n", "should stand here");
    expect_refused("face.obj", obj_triangle + "f" + repeated(" 1 2 3", size / 6) + "\n", "");
    expect_refused("groups.obj", "g " + repeated("a ", size / 2) + "\n", "no faces");
    expect_refused("lines.obj", std::string(size, '\n'), "no faces");
    expect_refused("returns.obj", repeated("v 0 0 0\r", size / 8), "no faces");
    expect_refused("comment.off", "OFF\n" + std::string(size, '#'), "the file ends");
    expect_refused("facets.stl", "solid\n" + repeated("facet\nouter\n", size / 12), "should stand here");
    expect_refused("rings.poly", nested_squares(6000), "only one facet has edge");
}

TEST_F(Hostile, CoordinatesAreFiniteAndNoneIsTooGreat) {
    for (const char* number :
         {"nan", "inf", "-inf", "1e309", "-1e999", "nan(1)", "infinity", "0x1p3", "1e", ""}) {
        const std::string point = std::string("0 0 ") + number + "\n";
        EXPECT_EQ(run_on("check", "point.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n" + point + "3 0 1 2\n").code, 2);
        EXPECT_EQ(run_on("check", "point.obj", "v 0 0 0\nv 1 0 0\nv " + point + "f 1 2 3\n").code, 2);
        EXPECT_EQ(
            run_on("check", "point.poly", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 " + point + "1 0\n1\n3 1 2 3\n").code,
            2)
            << number;
    }
    // Numbers that are finite, and boxes that are not, or of which nothing is left on the lattice.
    for (const double far : {1e308, 1.7e308, 1e-300, 5e-324}) {
        for (const double low : {0.0, -far, far / 2}) {
            const Ran ran = run_on("check", "far.off", box_off({low, low, low}, {far, far, far}));
            EXPECT_TRUE(ran.code == 0 || ran.code == 2) << far << ' ' << low << ' ' << ran.err;
            EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), ran.code == 0 ? 0 : 1) << ran.err;
        }
    }
    const std::string box = box_off({0, 0, 0}, {1, 1, 1});
    const auto convert = [&](const std::string& frame) {
        return run_on("convert --depth 2 -o '" + path("o.osem") + "' --frame=" + frame, "frame.off", box);
    };
    EXPECT_EQ(convert("0,0,0,1").code, 0);
    for (const char* frame :
         {"0,0,0,inf", "nan,0,0,1", "0,0,0,0", "0,0,0,-1", "0,0,0,1e309", "1e308,0,0,1e308", "0,0,0"}) {
        EXPECT_TRUE(failed(convert(frame), 1, "--frame")) << frame;
    }
    for (const char* frame : {"1e308,0,0,1", "0,0,0,5e-324", "-1.7e308,0,0,1.7e308"}) {
        EXPECT_EQ(convert(frame).code, 2) << frame;
    }
}

TEST_F(Hostile, NothingThatAFileNamesIsOpened) {
    ASSERT_EQ(mkfifo(path("waits").c_str(), 0600), 0); // whoever opens it, waits for a writer
    const std::string obj = "mtllib waits\nusemtl " + path("waits") + "\nmtllib " + path("waits") + "\n" +
                            obj_triangle + "v 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    EXPECT_TRUE(succeeded(run_on("check", "materials.obj", obj)));
}

TEST_F(Hostile, WhatIsNoRegularFileIsNotRead) {
    for (const std::string end : {".off", ".stl", ".obj", ".poly", ".osem"}) {
        const std::string command = end == ".osem" ? "info" : "check";
        fs::create_symlink("/dev/zero", path("device" + end)); // has no end
        ASSERT_EQ(mkfifo(path("pipe" + end).c_str(), 0600), 0);
        fs::create_directory(path("folder" + end));
        for (const std::string name : {"device", "pipe", "folder"}) {
            EXPECT_TRUE(failed(osem({command, path(name + end)}), 2, "is not a regular file")) << name << end;
        }
    }
}

TEST_F(Hostile, DeepExpressionsAndOddNames) {
    make_box("a", {0, 0, 0}, {0.5, 1, 1});
    const auto csg = [&](const std::string& expression, const std::string& binding) {
        return osem({"csg", expression, binding, "-o", path("r.osem")});
    };
    const std::string file = "a=" + path("a.off");
    for (const std::size_t depth : {std::size_t{65}, std::size_t{100000}}) {
        EXPECT_TRUE(failed(csg(std::string(depth, '('), file), 1, "nested too deeply"));
        EXPECT_TRUE(failed(csg(std::string(depth, '!') + "a", file), 1, "nested too deeply"));
        EXPECT_TRUE(failed(csg(std::string(depth, '(') + "a" + std::string(depth, ')'), file), 1, "nested"));
    }
    EXPECT_TRUE(failed(csg("a" + repeated("-a", 50000), file), 1, "too large"));
    EXPECT_TRUE(failed(csg(std::string(100000, 'a'), file), 1, "no file is given"));
    EXPECT_TRUE(failed(csg("", file), 1, ""));
    EXPECT_TRUE(failed(csg("a\na", file), 1, "expected an operator"));
    // Only the first = divides, and what stands behind it is a file's name, whatever it looks like.
    fs::copy_file(path("a.off"), path("b=c.off"));
    EXPECT_TRUE(succeeded(csg("a", "a=" + path("b=c.off"))));
    EXPECT_TRUE(failed(csg("a", "a=--output"), 2, "--output"));
    EXPECT_TRUE(failed(csg("a", "a=" + path("a.off") + "/../a.off"), 2, "a.off"));
    EXPECT_TRUE(failed(csg("a", "a=" + path("")), 2, ""));
    std::vector<std::string> many = {"csg", "a", "-o", path("r.osem")};
    for (int i = 0; i < 1000; ++i) many.push_back("a" + std::to_string(i) + "=" + path("a.off"));
    EXPECT_TRUE(failed(osem(many), 1, "at most 16 files"));
}

// By whatever name an input goes, a command that cannot read it to the end before it writes refuses it as
// output, and the bytes stay.
TEST_F(Hostile, NoInputIsWrittenOver) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    fs::create_directory(path("folder"));
    const std::string mesh = path("box.off");
    const std::string tree = path("box.osem");
    for (const std::string& input : {mesh, tree}) {
        const std::string end = fs::path(input).extension().string();
        fs::create_symlink(input, path("symbolic" + end));
        fs::create_hard_link(input, path("hard" + end));
        fs::create_symlink(path("symbolic" + end), path("twice" + end));
        const std::string bytes = read_file(input);
        for (const std::string& name : {path("symbolic" + end), path("hard" + end), path("twice" + end),
                                        path("folder/../box" + end), path("./box" + end)}) {
            std::vector<std::vector<std::string>> lines;
            if (input == mesh) {
                lines = {{"convert", mesh, "-o", name},
                         {"convert", mesh, "-o", path("o.osem"), "--quantized", name},
                         {"csg", "a", "a=" + mesh, "-o", name},
                         {"carray", mesh, "-o", name}};
            } else {
                lines = {{"mesh", tree, "-o", name},
                         {"slice", tree, "--axis", "z", "--at", "0.5", "--runs", "-o", name},
                         {"carray", tree, "-o", name}};
            }
            for (const auto& line : lines) {
                EXPECT_EQ(osem(line).code, 1) << line[0] << ' ' << name;
                EXPECT_EQ(read_file(input), bytes) << line[0] << ' ' << name;
            }
        }
    }
}

// A file of a few bytes may state a depth of 20, so a stack of a million pictures.
TEST_F(Hostile, AStackHasAnEnd) {
    make_box("deep", {0.5, 0.5, 0.5}, {1, 1, 1}, {"--depth", "20"});
    ASSERT_LT(fs::file_size(path("deep.osem")), 100U);
    const auto before = files();
    const auto stack = [&](const std::vector<std::string>& more) {
        std::vector<std::string> line = {"slice", path("deep.osem"), "--axis", "z", "--stack"};
        line.insert(line.end(), more.begin(), more.end());
        return osem(line);
    };
    const std::string out = path("s%d.png");
    EXPECT_TRUE(failed(stack({"-o", out}), 2, "a stack of 1048576 layers; 16384 at most"));
    EXPECT_TRUE(failed(stack({"--runs"}), 2, "16384 at most"));
    EXPECT_TRUE(failed(stack({"--every", "63", "-o", out}), 2, "a stack of 16645 layers"));
    EXPECT_TRUE(failed(stack({"--level", "15", "-o", out}), 2, "a stack of 32768 layers"));
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(succeeded(stack({"--every", "1048576", "--level", "20", "--runs", "-o", path("runs")})));
    EXPECT_TRUE(succeeded(stack({"--level", "3", "-o", out})));
}

} // namespace

} // namespace osem::tool_test
