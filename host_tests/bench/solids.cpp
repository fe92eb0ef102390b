#include "bench/solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "mesh/read_mesh.hpp"

namespace osem::bench {

namespace {

using Coordinates = std::array<double, 3>;

std::string mesh_path(const std::string& name) {
    if (name == "bracket") return OSEM_SAMPLES_DIR "/bracket.poly";
    const char* set = std::getenv("OSEM_CGAL_DATA");
    const std::string folder = set != nullptr ? set : OSEM_CGAL_DATA;
    if (folder.empty()) {
        throw std::runtime_error("OSEM_CGAL_DATA is not set: it names the folder of CGAL's data, which "
                                 "host_tests/bench/run.sh unpacks to build/cgal-demo/data");
    }
    return folder + "/meshes/" + name + ".off";
}

// The number behind a prefix; 0 when the name has another form.
std::uint32_t faces_in(const std::string& name, const std::string& prefix) {
    if (name.compare(0, prefix.size(), prefix) != 0) return 0;
    return static_cast<std::uint32_t>(std::strtoul(name.c_str() + prefix.size(), nullptr, 10));
}

Coordinates middle_on_sphere(const Coordinates& a, const Coordinates& b) {
    const Coordinates sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return {sum[0] / length, sum[1] / length, sum[2] / length};
}

using Soup = std::vector<std::array<Coordinates, 3>>;

Soup icosahedron() {
    const double t = (1 + std::sqrt(5.0)) / 2;
    const double r = std::sqrt(1 + t * t);
    std::vector<Coordinates> at;
    for (const double a : {-1 / r, 1 / r}) {
        for (const double b : {-t / r, t / r}) {
            at.insert(at.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
        }
    }
    // Three vertices are a face when their determinant, six times the volume under them, is the greatest.
    const auto volume = [&at](std::size_t i, std::size_t j, std::size_t k) {
        const Coordinates &p = at[i], &q = at[j], &s = at[k];
        return p[0] * (q[1] * s[2] - q[2] * s[1]) + p[1] * (q[2] * s[0] - q[0] * s[2]) +
               p[2] * (q[0] * s[1] - q[1] * s[0]);
    };
    const auto near = [&at](std::size_t i, std::size_t j) {
        return at[i][0] * at[j][0] + at[i][1] * at[j][1] + at[i][2] * at[j][2] > 0.4;
    };
    Soup faces;
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = i + 1; j < 12; ++j) {
            for (std::size_t k = i + 1; k < 12; ++k) {
                if (near(i, j) && near(j, k) && near(k, i) && volume(i, j, k) > 0) {
                    faces.push_back({at[i], at[j], at[k]});
                }
            }
        }
    }
    return faces;
}

// An icosahedron's faces divided by four until there are enough. Both faces of an edge compute the same
// middle, so that the surface is closed when equal points are one vertex.
host::Mesh sphere(std::uint32_t faces) {
    Soup soup = icosahedron();
    while (soup.size() < faces) {
        Soup finer;
        finer.reserve(4 * soup.size());
        for (const auto& [a, b, c] : soup) {
            const Coordinates ab = middle_on_sphere(a, b);
            const Coordinates bc = middle_on_sphere(b, c);
            const Coordinates ca = middle_on_sphere(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        soup.swap(finer);
    }
    host::Mesh mesh;
    for (const auto& face : soup) {
        for (const Coordinates& corner : face) {
            mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(corner);
        }
        mesh.end_ring();
        mesh.end_face();
    }
    return mesh;
}

void add_face(host::Mesh& mesh, std::initializer_list<std::uint32_t> corners) {
    mesh.corners.insert(mesh.corners.end(), corners);
    mesh.end_ring();
    mesh.end_face();
}

// An octahedron and a cube that overlap, in lattice units. Vertices, edges and faces pass through cells'
// centres at 256 cells along an axis.
host::Mesh ties() {
    constexpr double middle = root_side / 2.0 + root_side / 512.0;
    constexpr double radius = root_side / 4.0;
    host::Mesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double offset : {-radius, radius}) {
            Coordinates vertex{middle, middle, middle};
            vertex[axis] += offset;
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t k = 0; k < 8; ++k) {
        const std::uint32_t x = k & 1U, y = 2 + (k >> 1 & 1U), z = 4 + (k >> 2);
        const bool is_outward = ((x + y + z) & 1U) != 0;
        add_face(mesh, {x, is_outward ? y : z, is_outward ? z : y});
    }
    for (std::uint32_t k = 0; k < 8; ++k) {
        const auto at = [&](std::uint32_t bit) {
            return middle + ((k & bit) != 0 ? radius / 2 : -radius / 2);
        };
        mesh.vertices.push_back({at(1), at(2), at(4)});
    }
    for (const std::uint32_t x : {1U, 2U, 4U}) {
        const std::uint32_t y = x == 4 ? 1 : 2 * x, z = 7 - x - y;
        add_face(mesh, {6, 6 + z, 6 + z + y, 6 + y});
        add_face(mesh, {6 + x, 6 + x + y, 6 + x + y + z, 6 + x + z});
    }
    return mesh;
}

// The cube in whose middle the mesh takes 1 / `shrink` of the root's side, less the margin.
host::WorldCube fitted_cube(const host::Mesh& mesh, double shrink) {
    Coordinates low = mesh.vertices.at(mesh.corners.at(0));
    Coordinates high = low;
    for (const std::uint32_t vertex : mesh.corners) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], mesh.vertices[vertex][axis]);
            high[axis] = std::max(high[axis], mesh.vertices[vertex][axis]);
        }
    }
    const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    host::WorldCube cube{};
    cube.side = shrink * extent * root_side / (root_side - 2 * 777);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cube.origin[axis] = (low[axis] + high[axis]) / 2 - cube.side / 2;
    }
    return cube;
}

host::IntegerSolid quantized(const std::string& name) {
    if (name == "ties") return host::quantize(ties(), host::WorldCube{{0, 0, 0}, root_side});
    const std::uint32_t whole = faces_in(name, "sphere-");
    const std::uint32_t small = faces_in(name, "dot-");
    const host::Mesh mesh = whole + small != 0 ? sphere(whole + small) : host::read_mesh(mesh_path(name));
    return host::quantize(mesh, fitted_cube(mesh, small != 0 ? 16 : 1));
}

std::unique_ptr<BenchSolid> made(const std::string& name) {
    auto result = std::make_unique<BenchSolid>();
    result->solid = quantized(name);
    static_cast<void>(host::check_or_throw(result->solid));
    const Solid view = result->solid.view();
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        const auto triangles = host::triangulate_face(view, face);
        result->triangles.insert(result->triangles.end(), triangles.begin(), triangles.end());
    }
    return result;
}

} // namespace

const BenchSolid& solid_of(const std::string& name) {
    static std::map<std::string, std::unique_ptr<BenchSolid>> known;
    std::unique_ptr<BenchSolid>& entry = known[name];
    if (entry != nullptr) return *entry;
    try {
        entry = made(name);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), e.what());
        std::exit(1);
    }
    return *entry;
}

} // namespace osem::bench
