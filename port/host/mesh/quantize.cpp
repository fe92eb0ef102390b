#include "mesh/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/coordinates.hpp"
#include "mesh/edge_uses.hpp"
#include "mesh/flat.hpp"
#include "mesh/orient.hpp"
#include "mesh/ring_nesting.hpp"
#include "mesh/triangulate.hpp"
#include "mesh/welder.hpp"

namespace osem::host {

namespace {

constexpr std::uint32_t none = UINT32_MAX;

// Triangulation takes time with the square of the corners. A planar face may have more.
constexpr std::uint32_t max_bent_corners = 20000;

class LatticeMap {
  public:
    explicit LatticeMap(const WorldCube& cube) : cube_(cube), scale_(root_side / cube.side) {
        const bool finite = std::isfinite(cube.origin[0]) && std::isfinite(cube.origin[1]) &&
                            std::isfinite(cube.origin[2]) && std::isfinite(cube.side) &&
                            std::isfinite(scale_);
        if (!finite || !(cube.side > 0) || !(scale_ > 0)) {
            throw BadInput("the world cube needs a finite origin and a finite side above 0");
        }
    }

    Point operator()(const Mesh& mesh, std::uint32_t vertex) const {
        Point point{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = std::floor((mesh.vertices[vertex][axis] - cube_.origin[axis]) * scale_ + 0.5);
            if (!(x >= 0 && x <= root_side)) refuse(mesh, vertex); // also when x is not a number
            point.at[axis] = static_cast<std::int32_t>(x);
        }
        return point;
    }

  private:
    [[noreturn]] void refuse(const Mesh& mesh, std::uint32_t vertex) const {
        const auto& at = mesh.vertices[vertex];
        const std::string what = "vertex " + std::to_string(vertex) + " (counted from 0) at " + to_text(at);
        if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2])) {
            throw BadInput(what + " is not finite");
        }
        const std::array<double, 3> end{cube_.origin[0] + cube_.side, cube_.origin[1] + cube_.side,
                                        cube_.origin[2] + cube_.side};
        throw BadInput(what + " lies outside the world cube, " + to_text(cube_.origin) + " to " +
                       to_text(end));
    }

    const WorldCube& cube_;
    double scale_;
};

// The faces' vertices on the lattice; equal points are one vertex unless they are to stay `apart`. Returns
// the new number of each.
std::vector<std::uint32_t> take_vertices(const Mesh& mesh, bool apart, IntegerSolid& solid) {
    const LatticeMap to_lattice(solid.cube);
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), none);
    Welder welder(solid.vertices);
    for (const std::uint32_t vertex : mesh.corners) {
        if (renumbered[vertex] != none) continue;
        const std::size_t before = solid.vertices.size();
        const Point point = to_lattice(mesh, vertex);
        if (apart) {
            renumbered[vertex] = static_cast<std::uint32_t>(before);
            solid.vertices.push_back(point);
        } else {
            renumbered[vertex] = welder.add(point);
        }
        if (solid.vertices.size() > before) {
            solid.file_coordinates.push_back(mesh.vertices[vertex]);
        } else {
            ++solid.welded_vertices;
        }
    }
    return renumbered;
}

// Makes equal points that were apart one vertex.
void weld(IntegerSolid& solid) {
    std::vector<Point> points;
    std::vector<std::uint32_t> renumbered;
    renumbered.reserve(solid.vertices.size());
    Welder welder(points);
    for (std::size_t vertex = 0; vertex < solid.vertices.size(); ++vertex) {
        const std::size_t before = points.size();
        renumbered.push_back(welder.add(solid.vertices[vertex]));
        if (points.size() > before) {
            solid.file_coordinates[before] = solid.file_coordinates[vertex];
        } else {
            ++solid.welded_vertices;
        }
    }
    solid.file_coordinates.resize(points.size());
    solid.vertices = std::move(points);
    for (std::uint32_t& corner : solid.corners) corner = renumbered[corner];
}

// Adds the corners of a ring, without those that repeat the one before.
void add_corners(const Mesh& mesh, std::uint32_t ring, const std::vector<std::uint32_t>& renumbered,
                 IntegerSolid& solid) {
    std::vector<std::uint32_t>& corners = solid.corners;
    const std::size_t start = corners.size();
    const auto at = [&solid](std::uint32_t vertex) { return solid.vertices[vertex]; };
    for (std::uint32_t i = mesh.ring_starts[ring]; i < mesh.ring_starts[ring + 1]; ++i) {
        const std::uint32_t vertex = renumbered[mesh.corners[i]];
        if (corners.size() == start || at(corners.back()) != at(vertex)) corners.push_back(vertex);
    }
    while (corners.size() > start + 1 && at(corners.back()) == at(corners[start])) corners.pop_back();
}

// Rings of two corners may go: their two edges are opposite, so what is left is as closed as before. A
// triangle without area may not, for it can be what joins a long edge to the halves of it.
void take_faces(const Mesh& mesh, const std::vector<std::uint32_t>& renumbered, IntegerSolid& solid) {
    solid.corners.reserve(mesh.corners.size());
    solid.ring_starts.reserve(mesh.ring_starts.size());
    solid.face_rings.reserve(mesh.face_rings.size());
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
        const std::size_t start = solid.corners.size();
        const std::uint32_t rings = solid.ring_count();
        for (std::uint32_t ring = mesh.face_rings[face]; ring < mesh.face_rings[face + 1]; ++ring) {
            const std::size_t ring_start = solid.corners.size();
            add_corners(mesh, ring, renumbered, solid);
            if (solid.corners.size() < ring_start + 3) {
                solid.corners.resize(ring_start);
            } else {
                solid.end_ring();
            }
        }
        if (solid.corners.size() - start > max_face_corners) {
            throw BadInput("face " + std::to_string(face) + " (counted from 0) has more than " +
                           std::to_string(max_face_corners) + " corners");
        }
        if (solid.ring_count() > rings) {
            solid.end_face();
        } else {
            ++solid.dropped_faces;
        }
    }
}

void add_face(const Solid& solid, std::uint32_t face, FaceTable& faces) {
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        faces.corners.insert(faces.corners.end(), ring.corners, ring.corners + ring.count);
        faces.end_ring();
    }
    faces.end_face();
}

void add_triangles(const Solid& solid, std::uint32_t face, FaceTable& faces) {
    const std::uint32_t first = solid.first_corner(solid.first_ring(face));
    if (solid.first_corner(solid.end_ring(face)) - first > max_bent_corners) {
        throw BadInput("a face with more than " + std::to_string(max_bent_corners) +
                       " corners is not planar on the lattice; give it as triangles");
    }
    for (const Triangle& triangle : triangulate_face(solid, face)) {
        faces.corners.insert(faces.corners.end(), triangle.begin(), triangle.end());
        faces.end_ring();
        faces.end_face();
    }
}

// Cuts the faces that are not planar into triangles, which always are.
void flatten(IntegerSolid& solid) {
    const Solid view = solid.view();
    std::vector<bool> bent(view.face_count);
    for (std::uint32_t face = 0; face < view.face_count; ++face) bent[face] = !is_planar(view, face);
    solid.triangulated_faces = static_cast<std::uint32_t>(std::count(bent.begin(), bent.end(), true));
    if (solid.triangulated_faces == 0) return;
    FaceTable faces;
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        if (bent[face]) {
            add_triangles(view, face, faces);
        } else {
            add_face(view, face, faces);
        }
    }
    static_cast<FaceTable&>(solid) = std::move(faces);
}

// Whether the surface closes with the vertices as the file has them, two facets at every edge. Then these say
// which facets belong together where sheets of the surface touch along an edge, as the points do not. Only
// where all is planar: a face that is to be cut must have one vertex where it passes through a point twice.
bool closes_apart(const IntegerSolid& solid) {
    const Solid view = solid.view();
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        if (!is_planar(view, face)) return false;
    }
    bool in_pairs = true;
    for_each_edge(edge_uses(solid, view.vertex_count, next_corners(solid)),
                  [&](const EdgeUse* first, const EdgeUse* end) { in_pairs = in_pairs && end - first == 2; });
    return in_pairs;
}

bool has_triangles_only(const FaceTable& faces) {
    if (faces.ring_count() != faces.face_count()) return false; // a face has one ring at least
    for (std::uint32_t ring = 0; ring < faces.ring_count(); ++ring) {
        if (faces.ring_starts[ring + 1] - faces.ring_starts[ring] != 3) return false;
    }
    return true;
}

} // namespace

Solid IntegerSolid::view() const {
    return {vertices.data(),
            static_cast<std::uint32_t>(vertices.size()),
            corners.data(),
            static_cast<std::uint32_t>(corners.size()),
            triangles_only ? nullptr : ring_starts.data(),
            triangles_only ? nullptr : face_rings.data(),
            face_count()};
}

IntegerSolid quantize(const Mesh& mesh, const WorldCube& cube) {
    if (mesh.vertices.size() >= none) throw BadInput("the mesh has more vertices than 32 bits can count");
    IntegerSolid solid;
    solid.cube = cube;
    solid.oriented = mesh.oriented;
    solid.input_faces = mesh.face_count();
    solid.input_vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    take_faces(mesh, take_vertices(mesh, !mesh.oriented, solid), solid);
    solid.triangles_only = has_triangles_only(solid);
    if (!mesh.oriented) {
        if (!closes_apart(solid)) weld(solid);
        static_cast<FaceTable&>(solid) = nest_rings(solid, solid.vertices);
        solid.triangles_only = has_triangles_only(solid);
    }
    flatten(solid);
    solid.triangles_only = has_triangles_only(solid);
    if (!mesh.oriented) {
        orient_even_odd(solid);
        weld(solid);
    }
    return solid;
}

} // namespace osem::host
