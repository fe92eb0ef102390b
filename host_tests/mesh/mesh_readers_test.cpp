// Mesh files: what is read, and what is refused with its place.
#include "mesh/read_mesh.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "mesh/bad_input.hpp"

namespace osem::host {
namespace {

using Corners = std::vector<std::uint32_t>;

class TemporaryFile {
  public:
    TemporaryFile(const std::string& name, const std::string& bytes)
        : path_(::testing::TempDir() + ::testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
                name) {
        std::ofstream(path_, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { std::remove(path_.c_str()); }
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

Mesh read(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    return read_mesh(file.path());
}

// The message of the refusal, behind the file's name; empty when there is none.
std::string refusal(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    try {
        read_mesh(file.path());
    } catch (const BadInput& fault) {
        const std::string what = fault.what();
        EXPECT_EQ(what.rfind(file.path() + ": ", 0), 0U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return what.substr(file.path().size() + 2);
    }
    return "";
}

#define EXPECT_REFUSED(name, bytes, start)                                                                   \
    EXPECT_EQ(refusal(name, bytes).rfind(start, 0), 0U) << refusal(name, bytes)

TEST(ReadOff, PolygonsCommentsAndColours) {
    const Mesh mesh =
        read("a.OFF", "# a comment\nOFF 5 2 0 # counts here\n\n0 0 0\n1.5 +0 -2e-1\r\n1 1 0\n0 1 0\n"
                      "0.5 0.5 1\n4 0 1 2 3 255 0 0 # red\n3 0\n1 4");
    EXPECT_TRUE(mesh.oriented);
    ASSERT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.vertices[1], (std::array<double, 3>{1.5, 0, -0.2}));
    EXPECT_EQ(mesh.corners, (Corners{0, 1, 2, 3, 0, 1, 4}));
    EXPECT_EQ(mesh.ring_starts, (Corners{0, 4, 7}));
    EXPECT_EQ(mesh.face_rings, (Corners{0, 1, 2}));
}

TEST(ReadOff, Refusals) {
    const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_EQ(refusal("good.off", head + "3 0 1 2\n"), "");
    EXPECT_REFUSED("a.off", "", "line 1: the file ends where the keyword OFF");
    EXPECT_REFUSED("a.off", "COFF\n3 1 0\n", "line 1: the file begins with 'COFF'");
    EXPECT_REFUSED("a.off", "3 1 0\n0 0 0\n", "line 1: the file begins with '3'");
    EXPECT_REFUSED("a.off", head + "3 0 1 3\n", "line 6: vertex index 3 is out of range");
    EXPECT_REFUSED("a.off", head + "3 0 1 -1\n", "line 6: '-1' is not an unsigned whole number");
    EXPECT_REFUSED("a.off", head + "3 0 1 4294967296\n", "line 6: a vertex index '4294967296' is too great");
    EXPECT_REFUSED("a.off", head + "2 0 1 #\n", "line 6: a face has 2 corners");
    EXPECT_REFUSED("a.off", head + "3 0 1\n", "line 7: the file ends where a vertex index");
    EXPECT_REFUSED("a.off", head + "3 0 1 2\n3 0 1 2\n", "line 7: more data follows");
    EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "line 4: 'x' is not a finite");
    EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "line 4: 'nan' is not a finite");
    EXPECT_REFUSED("a.off", "OFF\n3 1 0\n0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n", "line 4: '1e999' is not");
}

TEST(ReadOff, AnnouncedNumbersAreNotTrusted) {
    EXPECT_REFUSED("a.off", "OFF\n4000000000 1 0\n0 0 0\n",
                   "line 2: the number of vertices 4000000000 is more");
    EXPECT_REFUSED("a.off", "OFF\n1 4000000000 0\n0 0 0\n", "line 2: the number of faces 4000000000 is more");
    EXPECT_REFUSED("a.off", "OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", "line 4: a face's number of corners");
}

TEST(ReadMesh, NamesOfFiles) {
    EXPECT_REFUSED("a.ply", "ply\n", "unknown kind of mesh file");
    EXPECT_REFUSED("a.osem", "OSEM", "a tree, not a mesh");
    EXPECT_THROW(read_mesh(::testing::TempDir() + "no_such_file.off"), BadInput);
    EXPECT_THROW(read_mesh(::testing::TempDir() + "no_extension"), BadInput);
}

const char* const ascii_stl =
    "solid two words\n facet normal 0 0 1\n  OUTER loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
    "   vertex 0 2.5 0\n  endloop\n endfacet\nendsolid two words\n";

TEST(ReadStl, Ascii) {
    const Mesh mesh = read("a.stl", ascii_stl);
    ASSERT_EQ(mesh.vertices.size(), 3U);
    EXPECT_EQ(mesh.vertices[2], (std::array<double, 3>{0, 2.5, 0}));
    EXPECT_EQ(mesh.corners, (Corners{0, 1, 2}));
    EXPECT_EQ(mesh.face_count(), 1U);
    EXPECT_EQ(read("b.stl", std::string(ascii_stl) + ascii_stl).face_count(), 2U); // two solids
}

TEST(ReadStl, AsciiRefusals) {
    const std::string text = ascii_stl;
    EXPECT_REFUSED("a.stl", text.substr(0, text.find("endsolid")), "line 9: the file ends where facet or");
    EXPECT_REFUSED("a.stl", text.substr(0, text.find("  endloop")) + "vertex 1 1 1\n",
                   "line 7: 'endloop' should stand here, not 'vertex'");
    EXPECT_REFUSED("a.stl", "facet\n", "line 1: 'solid' should stand here");
    EXPECT_REFUSED("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n",
                   "line 4: 'inf' is not");
}

// Little-endian whatever the host is. The values are sums of powers of two, written down as their bits.
std::string little_endian(std::uint32_t bits) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xffU);
    return bytes;
}

std::string binary_stl(const std::string& title, std::uint32_t announced, std::uint32_t triangles) {
    std::string bytes = title;
    bytes.resize(80, '\0');
    bytes += little_endian(announced);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        bytes.append(12, '\0');
        for (const std::uint32_t bits : {0U, 0U, 0U, 0x3f800000U, 0U, 0U, 0U, 0xc0200000U, 0x3e000000U}) {
            bytes += little_endian(bits);
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

TEST(ReadStl, Binary) {
    const Mesh mesh = read("a.stl", binary_stl("solid in name only", 2, 2));
    EXPECT_EQ(mesh.face_count(), 2U);
    ASSERT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.vertices[4], (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(mesh.vertices[5], (std::array<double, 3>{0, -2.5, 0.125}));
    EXPECT_EQ(mesh.corners, (Corners{0, 1, 2, 3, 4, 5}));
}

TEST(ReadStl, BinaryRefusals) {
    EXPECT_REFUSED("a.stl", binary_stl("", 3, 2), "byte 80: the header announces 3 triangles, so 234 bytes");
    EXPECT_REFUSED("a.stl", binary_stl("solid", 0xffffffffU, 2), "byte 80: the header announces 4294967295");
    EXPECT_REFUSED("a.stl", binary_stl("", 2, 2) + "x", "byte 80: the header announces 2 triangles");
    EXPECT_REFUSED("a.stl", std::string(83, '\0'), "byte 0: too short");
    std::string infinite = binary_stl("", 1, 1);
    infinite.replace(84 + 12 + 16, 4, little_endian(0x7f800000U)); // the second vertex's y
    EXPECT_REFUSED("a.stl", infinite, "byte 112: a coordinate of triangle 0 is not a finite number");
}

TEST(ReadObj, FacesOfEveryKind) {
    const Mesh mesh =
        read("a.obj", "# comment\no part\nv 0 0 0\nv 1 0 0\nv 1 0.1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n"
                      "usemtl none\nf 1 2 3 4\nf 1/1 2/1/1 3//1\nf -4 -3 -1\nv 5 5 5\r\nf 5 1 2\n");
    ASSERT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.vertices[2], (std::array<double, 3>{1, 0.1, 0}));
    EXPECT_EQ(mesh.corners, (Corners{0, 1, 2, 3, 0, 1, 2, 0, 1, 3, 4, 0, 1}));
    EXPECT_EQ(mesh.ring_starts, (Corners{0, 4, 7, 10, 13}));
    EXPECT_EQ(mesh.face_count(), 4U);
}

TEST(ReadObj, ManyCornersStayOnePolygon) {
    std::string text;
    std::string face = "f";
    for (int i = 1; i <= 300; ++i) {
        text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
        face += " " + std::to_string(i);
    }
    EXPECT_EQ(read("a.obj", text + face).ring_starts, (Corners{0, 300}));
}

TEST(ReadObj, Refusals) {
    const std::string head = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\n";
    EXPECT_EQ(refusal("good.obj", head + "f 1 2 3"), "");
    EXPECT_REFUSED("a.obj", head + "f 1 2 4\n", "line 5: vertex index 4 is out of range");
    EXPECT_REFUSED("a.obj", head + "f 1 2 0\n", "line 5: vertex index 0 is out of range");
    EXPECT_REFUSED("a.obj", head + "f 1 2 -4\n", "line 5: vertex index -4 is out of range");
    EXPECT_REFUSED("a.obj", head + "f 1 2\n", "line 5: a face has 2 corners");
    EXPECT_REFUSED("a.obj", head + "f 4294967297 2 3\n", "line 5: vertex index 4294967297 is out of range");
    for (const char* corner :
         {"1.7", "1abc", "1/x", "1/2/", "1/2/3/4", "/1", "1//", "99999999999999999999", "+1"}) {
        EXPECT_REFUSED("a.obj", head + "f 2 3 " + corner + "\n", "line 5: a face has the corner ");
    }
    EXPECT_EQ(refusal("good.obj", head + "f 1/9 2//9 3/9/9\n"), "");
    EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 zero 0\n", "line 2: a vertex needs three finite numbers");
    EXPECT_REFUSED("a.obj", "v 0 0 0\nv 1 0\nv 7 7 7\n", "line 2: a vertex needs three finite numbers");
}

// A tetrahedron, nodes numbered from 0 or 1.
std::string poly(unsigned first) {
    const auto node = [&](unsigned i) { return std::to_string(first + i); };
    std::string text = "# nodes\n4 3 1 0\n";
    const char* const points[4] = {" 0 0 0", " 4 0 0", " 0 4 0", " 0 0 4"};
    for (unsigned i = 0; i < 4; ++i) text += node(i) + points[i] + " 7.5 # attribute\n";
    text += "4 1\n1 0 9 # marker\n3 " + node(0) + " " + node(1) + "\n  " + node(2) + "\n";
    text += "1\n3 " + node(0) + " " + node(1) + " " + node(3) + "\n1\n3 " + node(0) + " " + node(2) + " " +
            node(3);
    return text + "\n1\n3 " + node(1) + " " + node(2) + " " + node(3) + "\n0\n0\n";
}

TEST(ReadPoly, NodesFromZeroOrOne) {
    for (const unsigned first : {0U, 1U}) {
        const Mesh mesh = read("a.poly", poly(first));
        EXPECT_FALSE(mesh.oriented);
        ASSERT_EQ(mesh.vertices.size(), 4U);
        EXPECT_EQ(mesh.vertices[3], (std::array<double, 3>{0, 0, 4}));
        EXPECT_EQ(mesh.corners, (Corners{0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3}));
        EXPECT_EQ(mesh.face_rings, (Corners{0, 1, 2, 3, 4}));
    }
}

TEST(ReadPoly, PolygonsOfAFacetAreItsRings) {
    const Mesh mesh =
        read("a.poly", "7 3 0 0\n1 0 0 0\n2 9 0 0\n3 9 9 0\n4 0 9 0\n5 1 1 0\n6 2 1 0\n7 1 2 0\n"
                       "1 0\n2 1\n4 1 2 3 4\n3 5 6 7\n1 1.2 1.2 0\n");
    EXPECT_EQ(mesh.ring_starts, (Corners{0, 4, 7}));
    EXPECT_EQ(mesh.face_rings, (Corners{0, 2}));
}

TEST(ReadPoly, Refusals) {
    const std::string nodes = "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";
    EXPECT_EQ(refusal("good.poly", nodes + "1 0\n1\n3 1 2 3\n"), "");
    EXPECT_REFUSED("a.poly", "0 3 0 0\n1 0\n", "line 1: the nodes are in a separate .node file");
    EXPECT_REFUSED("a.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "line 1: the dimension must be 3");
    EXPECT_REFUSED("a.poly", "2 3\n2 0 0 0\n3 0 0 0\n", "line 2: the first node's number must be 0 or 1");
    EXPECT_REFUSED("a.poly", "2 3\n1 0 0 0\n3 0 0 0\n", "line 3: node 2 should stand here");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n1\n3 1 2 4\n", "line 7: node 4 does not exist");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n1\n3 1 2 0\n", "line 7: node 0 does not exist");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n1\n2 1 2 # \n", "line 7: a polygon has 2 corners");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n0 0 # none\n", "line 6: a facet has no polygon");
    EXPECT_REFUSED("a.poly", nodes + "900000000 0\n1\n3 1 2 3\n",
                   "line 5: the number of facets 900000000 is more");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n1\n3 1 2 # no more", "line 7: the file ends where a node number");
    EXPECT_REFUSED("a.poly", nodes + "1 0\n1\n3 1 2 3\n1\n1 0 0 # z\n",
                   "line 10: the file ends where a coordinate");
}

} // namespace
} // namespace osem::host
