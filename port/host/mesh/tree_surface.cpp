#include "mesh/tree_surface.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "mesh/triangulate.hpp"

namespace osem::host {

Solid TreeSurface::view() const {
    return Solid{vertices.data(),    static_cast<std::uint32_t>(vertices.size()),
                 corners.data(),     static_cast<std::uint32_t>(corners.size()),
                 ring_starts.data(), face_rings.data(),
                 face_count()};
}

namespace {

// Steps a job to its end, walk `pass` of three.
BoundaryOutcome run(Boundary& job, std::uint64_t pass, const Report& report) {
    constexpr std::uint32_t pieces_a_step = 4096;
    constexpr std::uint64_t coarse = root_volume >> 20; // keeps passes * volume within 64 bits
    while (job.step(pieces_a_step)) report(pass * coarse + (job.walked_volume() >> 20), 3 * coarse);
    return job.finish();
}

struct Collector {
    static TreeSurface& of(void* context) { return *static_cast<TreeSurface*>(context); }
    static bool vertex(void* context, const Point& point) {
        of(context).vertices.push_back(point);
        return true;
    }
    static bool corner(void* context, std::uint32_t index) {
        of(context).corners.push_back(index);
        return true;
    }
    static bool end_ring(void* context) {
        of(context).end_ring();
        return true;
    }
    static bool end_face(void* context) {
        of(context).end_face();
        return true;
    }
};

} // namespace

TreeSurface surface_of(const Octree& tree, SolidPart part, const Report& report) {
    Boundary job;
    job.begin(tree, part, nullptr, 0);
    const BoundarySizes counted = run(job, 0, report).sizes;
    const std::uint32_t entries = boundary_scratch(counted.corners);
    const std::unique_ptr<BoundaryCorner[]> scratch(new BoundaryCorner[entries]);
    job.begin(tree, part, scratch.get(), entries);
    const BoundaryOutcome built = run(job, 1, report);

    TreeSurface surface;
    surface.double_edges = built.double_edges;
    surface.vertices.reserve(built.sizes.vertices);
    surface.corners.reserve(built.sizes.corners);
    surface.ring_starts.reserve(built.sizes.rings + std::size_t{1});
    surface.face_rings.reserve(built.sizes.faces + std::size_t{1});
    static_cast<void>(
        job.emit({Collector::vertex, Collector::corner, Collector::end_ring, Collector::end_face, &surface}));
    run(job, 2, report);
    return surface;
}

namespace {

using Offset = std::array<std::int64_t, 3>;

Offset between(const Point& a, const Point& b) {
    return {std::int64_t{b.at[0]} - a.at[0], std::int64_t{b.at[1]} - a.at[1],
            std::int64_t{b.at[2]} - a.at[2]};
}

// A corner of a face, and the way from it into the face where its ring turns.
struct Place {
    Point point;
    std::uint32_t vertex;
    Offset inwards;
};

bool before(const Point& a, const Point& b) {
    return std::lexicographical_compare(a.at, a.at + 3, b.at, b.at + 3);
}

// The sum of the unit steps from a corner to its neighbours.
Offset inwards_at(const Point& previous, const Point& at, const Point& next) {
    const Offset back = between(at, previous);
    const Offset on = between(at, next);
    Offset sum = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] = (back[axis] > 0) - (back[axis] < 0) + (on[axis] > 0) - (on[axis] < 0);
    }
    return sum;
}

std::vector<Place> places_of(const Solid& solid, std::uint32_t face) {
    std::vector<Place> places;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const Point& at = solid.vertices[ring.corners[i]];
            const Point& previous = solid.vertices[ring.corners[i == 0 ? ring.count - 1 : i - 1]];
            const Point& next = solid.vertices[ring.corners[i + 1 == ring.count ? 0 : i + 1]];
            places.push_back({at, ring.corners[i], inwards_at(previous, at, next)});
        }
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        return a.point == b.point ? a.vertex < b.vertex : before(a.point, b.point);
    });
    return places;
}

bool passes_twice(const std::vector<Place>& places) {
    const auto same = [](const Place& a, const Place& b) { return a.point == b.point; };
    return std::adjacent_find(places.begin(), places.end(), same) != places.end();
}

// Triangles of a face that may pass through a point twice, there being different vertices perhaps. It is
// triangulated with one of them in place of all. Where a ring passes twice each time it turns around a
// quarter, opposite to the other; so a triangle belongs to the vertex of the quarter it lies in.
class FaceSplitter {
  public:
    FaceSplitter(const TreeSurface& surface, std::uint32_t face, const std::vector<Place>& places)
        : places_(places), vertices_(surface.vertices) {
        const Solid view = surface.view();
        for (std::uint32_t r = view.first_ring(face); r < view.end_ring(face); ++r) {
            const Ring ring = view.ring(r);
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                corners_.push_back(first_at(vertices_[ring.corners[i]])->vertex);
            }
            ring_starts_.push_back(static_cast<std::uint32_t>(corners_.size()));
        }
    }

    std::vector<Triangle> operator()() const {
        const std::uint32_t face_rings[] = {0, static_cast<std::uint32_t>(ring_starts_.size() - 1)};
        const Solid welded = {vertices_.data(),
                              static_cast<std::uint32_t>(vertices_.size()),
                              corners_.data(),
                              static_cast<std::uint32_t>(corners_.size()),
                              ring_starts_.data(),
                              face_rings,
                              1};
        std::vector<Triangle> triangles = triangulate_face(welded, 0);
        for (Triangle& triangle : triangles) {
            const Triangle points = triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = vertex_in(vertices_[points[i]], vertices_[points[(i + 1) % 3]],
                                        vertices_[points[(i + 2) % 3]]);
            }
        }
        return triangles;
    }

  private:
    std::vector<Place>::const_iterator first_at(const Point& point) const {
        return std::lower_bound(places_.begin(), places_.end(), point,
                                [](const Place& place, const Point& p) { return before(place.point, p); });
    }

    std::uint32_t vertex_in(const Point& at, const Point& b, const Point& c) const {
        const Offset to_b = between(at, b);
        const Offset to_c = between(at, c);
        std::uint32_t vertex = 0;
        std::int64_t most = INT64_MIN;
        for (auto place = first_at(at); place != places_.end() && place->point == at; ++place) {
            std::int64_t ahead = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                ahead += place->inwards[axis] * (to_b[axis] + to_c[axis]);
            }
            if (ahead > most) {
                most = ahead;
                vertex = place->vertex;
            }
        }
        return vertex;
    }

    const std::vector<Place>& places_;
    const std::vector<Point>& vertices_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> ring_starts_{0};
};

} // namespace

TreeSurface in_simple_faces(const TreeSurface& surface, bool keep_polygons, const Report& report) {
    TreeSurface simple;
    simple.vertices = surface.vertices;
    simple.double_edges = surface.double_edges;
    const Solid view = surface.view();
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        report(face, view.face_count);
        const std::vector<Place> places = places_of(view, face);
        const bool one_ring = view.end_ring(face) - view.first_ring(face) == 1;
        if (keep_polygons && one_ring && !passes_twice(places)) {
            const Ring ring = view.ring(view.first_ring(face));
            simple.corners.insert(simple.corners.end(), ring.corners, ring.corners + ring.count);
            simple.end_ring();
            simple.end_face();
            continue;
        }
        for (const Triangle& triangle : FaceSplitter(surface, face, places)()) {
            simple.corners.insert(simple.corners.end(), triangle.begin(), triangle.end());
            simple.end_ring();
            simple.end_face();
        }
    }
    return simple;
}

} // namespace osem::host
