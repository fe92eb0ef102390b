// osem mesh: the surface of a tree as a file, and the tree that the file gives.
#include <array>
#include <random>
#include <sstream>

#include "support.hpp"

namespace osem::tool_test {

namespace {

class Meshes : public Tool {
  protected:
    // A box with a tunnel along z and a cube that touches the tunnel's rim along an edge only, and a box
    // between the leaves' borders: faces with holes, four faces at an edge, boundary leaves.
    void SetUp() override {
        Tool::SetUp();
        make_box("whole", {0, 0, 0}, {0.5, 0.5, 0.25});
        make_box("tunnel", {0.125, 0.125, 0}, {0.25, 0.25, 0.25});
        make_box("cube", {0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
        make_box("edge", {0.5, 0.5, 0}, {0.625, 0.625, 0.25});
        make_box("between", {0.7, 0.1, 0.6}, {0.95, 0.4, 0.9});
        ASSERT_TRUE(succeeded(combine("difference", "whole", "tunnel", "part")));
        ASSERT_TRUE(succeeded(combine("union", "part", "cube", "part")));
        ASSERT_TRUE(succeeded(combine("union", "part", "edge", "part")));
        ASSERT_TRUE(succeeded(combine("union", "part", "between", "part")));
    }
    Ran combine(const std::string& op, const std::string& a, const std::string& b, const std::string& to) {
        const Ran ran = osem({op, path(a + ".osem"), path(b + ".osem"), "-o", path("to.osem")});
        write_file(path(to + ".osem"), read_file(path("to.osem")));
        return ran;
    }
    Ran mesh(const std::string& name, const std::string& file, const std::string& solid = "inner") const {
        return osem({"mesh", path(name + ".osem"), "-o", path(file), "--solid", solid});
    }
    // The report on the tree that a mesh file gives at depth 3 in a frame.
    std::map<std::string, std::string> back(const std::string& file, const std::string& frame = "0,0,0,1") {
        EXPECT_TRUE(succeeded(osem({"convert", path(file), "-o", path("back.osem"), "--depth", "3",
                                    "--winding", "nonzero", "--frame", frame})));
        return info("back");
    }
};

TEST_F(Meshes, EveryFormatGivesTheInnerAndTheOuterSolidBack) {
    auto part = info("part");
    ASSERT_NE(part["boundary"], "0");
    for (const char* end : {".off", ".obj", ".stl", ".poly"}) {
        const std::string inner = std::string("inner") + end;
        const std::string outer = std::string("outer") + end;
        ASSERT_TRUE(succeeded(mesh("part", inner)));
        ASSERT_TRUE(succeeded(mesh("part", outer, "outer")));
        auto of_inner = back(inner);
        EXPECT_EQ(of_inner["boundary"], "0") << end;
        EXPECT_EQ(of_inner["volume_inner"], part["volume_inner"]) << end;
        auto of_outer = back(outer);
        EXPECT_EQ(of_outer["boundary"], "0") << end;
        EXPECT_EQ(of_outer["volume_inner"], part["volume_outer"]) << end;
    }
}

// Without boundary leaves inner and outer are one solid, and the tree comes back leaf for leaf.
TEST_F(Meshes, ATreeWithoutBoundaryComesBackItself) {
    ASSERT_TRUE(succeeded(combine("difference", "whole", "tunnel", "solid")));
    ASSERT_TRUE(succeeded(combine("union", "solid", "cube", "solid")));
    ASSERT_TRUE(succeeded(combine("union", "solid", "edge", "solid")));
    const std::string digest = info("solid")["digest"];
    for (const char* file : {"solid.off", "solid.obj", "solid.stl", "solid.poly"}) {
        for (const char* solid : {"inner", "outer"}) {
            ASSERT_TRUE(succeeded(mesh("solid", file, solid)));
            EXPECT_EQ(back(file)["digest"], digest) << file << ", " << solid;
        }
    }
}

// Cells of an 8 x 8 x 8 grid, each by the throw of a coin: sheets that touch along edges everywhere.
std::string rough_off(unsigned seed) {
    std::mt19937 random(seed);
    std::ostringstream vertices;
    std::ostringstream faces;
    unsigned cells = 0;
    for (unsigned i = 0; i < 512; ++i) {
        if (random() % 2 == 0) continue;
        for (unsigned k = 0; k < 8; ++k) {
            vertices << (i % 8 + (k & 1U)) * 0.125 << ' ' << (i / 8 % 8 + (k >> 1 & 1U)) * 0.125 << ' '
                     << (i / 64 + (k >> 2)) * 0.125 << '\n';
        }
        for (const auto& face : {std::array<unsigned, 4>{0, 2, 3, 1},
                                 {4, 5, 7, 6},
                                 {0, 1, 5, 4},
                                 {2, 6, 7, 3},
                                 {0, 4, 6, 2},
                                 {1, 3, 7, 5}}) {
            faces << 4;
            for (const unsigned corner : face) faces << ' ' << 8 * cells + corner;
            faces << '\n';
        }
        ++cells;
    }
    return "OFF\n" + std::to_string(8 * cells) + ' ' + std::to_string(6 * cells) + " 0\n" + vertices.str() +
           faces.str();
}

TEST_F(Meshes, ARoughTreeComesBackItself) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        write_file(path("rough.off"), rough_off(seed));
        ASSERT_TRUE(succeeded(osem(
            {"convert", path("rough.off"), "-o", path("rough.osem"), "--depth", "3", "--frame", "0,0,0,1"})));
        const std::string digest = info("rough")["digest"];
        for (const char* file : {"surface.off", "surface.poly"}) {
            ASSERT_TRUE(succeeded(mesh("rough", file)));
            EXPECT_EQ(back(file)["digest"], digest) << file << ", " << seed;
            EXPECT_TRUE(succeeded(osem({"check", path(file)}))) << seed;
        }
    }
}

TEST_F(Meshes, CheckFindsTheVolumeInWorldUnits) {
    make_box("far", {-70, 15, 30}, {-60, 25, 60}, {"--depth", "3"}, "-100,0,0,80");
    for (const char* file : {"far.off", "far.obj", "far.stl", "far.poly"}) {
        ASSERT_TRUE(succeeded(mesh("far", file, "outer")));
        EXPECT_EQ(back(file, "-100,0,0,80")["volume_inner"], info("far")["volume_outer"]) << file;
        const Ran ran = osem({"check", path(file)});
        ASSERT_TRUE(succeeded(ran));
        // check has a frame of its own, to whose lattice a corner is rounded.
        EXPECT_NEAR(std::stod(table(ran.out)["volume"]) / std::stod(info("far")["volume_outer_world"]), 1,
                    1e-5)
            << file;
    }
    auto part = info("part");
    for (const char* solid : {"inner", "outer"}) {
        ASSERT_TRUE(succeeded(mesh("part", "part.off", solid)));
        const Ran ran = osem({"check", path("part.off")});
        ASSERT_TRUE(succeeded(ran));
        const double expected = std::stod(part[std::string("volume_") + solid + "_world"]);
        EXPECT_NEAR(std::stod(table(ran.out)["volume"]) / expected, 1, 1e-5) << solid;
    }
}

// A cube is its six sides, whatever its leaves.
TEST_F(Meshes, AFaceIsWholeAndPolyKeepsItsHoles) {
    EXPECT_EQ(mesh("cube", "cube.off").out, "vertices 8\nfaces 6\ndouble_edges 0\n");
    EXPECT_EQ(mesh("cube", "cube.stl").out, "vertices 8\nfaces 12\ndouble_edges 0\n");
    ASSERT_TRUE(succeeded(combine("difference", "whole", "tunnel", "pierced")));
    EXPECT_EQ(mesh("pierced", "pierced.poly").out, "vertices 16\nfaces 10\ndouble_edges 0\n");
    auto report = table(osem({"check", path("pierced.poly")}).out);
    EXPECT_EQ(report["faces"], "10");
    EXPECT_EQ(report["hole_rings"], "2");
    EXPECT_EQ(report["manifold"], "yes");
    EXPECT_EQ(report["genus"], "1");
}

TEST_F(Meshes, WhatMakesNoSenseIsRefused) {
    make_box("thin", {0.7, 0.7, 0.7}, {0.71, 0.71, 0.71});
    write_file(path("kept.off"), "precious");
    write_file(path("cut.osem"), read_file(path("part.osem")).substr(0, 60));
    const auto before = files();
    EXPECT_TRUE(failed(mesh("part", "out.ply"), 1, ".off, .obj, .stl or .poly"));
    EXPECT_TRUE(failed(mesh("part", "out.off", "both"), 1, "--solid"));
    EXPECT_TRUE(failed(osem({"mesh", path("part.osem")}), 1, "--output"));
    EXPECT_TRUE(failed(mesh("none", "out.off"), 2, "none.osem"));
    EXPECT_TRUE(failed(mesh("part", "nowhere/out.off"), 2, "nowhere/out.off"));
    EXPECT_TRUE(failed(mesh("thin", "kept.off"), 2, "empty"));
    EXPECT_TRUE(failed(mesh("cut", "kept.off"), 2, "cut.osem"));
    EXPECT_EQ(read_file(path("kept.off")), "precious");
    EXPECT_EQ(files(), before);
}

} // namespace

} // namespace osem::tool_test
