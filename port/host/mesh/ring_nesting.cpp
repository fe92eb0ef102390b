#include "mesh/ring_nesting.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/bad_input.hpp"
#include "mesh/flat.hpp"

namespace osem::host {

namespace {

class FacetNester {
  public:
    FacetNester(const Solid& solid, std::uint32_t facet, FaceTable& faces)
        : solid_(solid), facet_(facet), faces_(faces) {}

    void operator()() {
        const std::uint32_t first = solid_.first_ring(facet_);
        const std::uint32_t end = solid_.end_ring(facet_);
        if (end - first == 1) return add_face(first);
        take_rings(first, end);
        for (NestedRing& ring : rings_) find_depth(ring);
        for (const NestedRing& ring : rings_) {
            if (!ring.is_hole()) add_face_with_holes(ring);
        }
    }

  private:
    struct NestedRing {
        std::uint32_t ring;
        std::vector<FlatPoint> polygon; ///< at twice the scale, so that middles of edges are points too
        std::int64_t area;              ///< twice the signed area, unscaled
        std::size_t depth;              ///< how many other rings it lies in
        bool is_hole() const { return depth % 2 == 1; }
    };

    void take_rings(std::uint32_t first, std::uint32_t end) {
        Normal longest{};
        std::vector<Normal> normals;
        normals.reserve(end - first);
        for (std::uint32_t ring = first; ring < end; ++ring) {
            normals.push_back(newell_normal(solid_, ring));
            if (length(normals.back()) > length(longest)) longest = normals.back();
        }
        const Projection project(longest);
        rings_.reserve(end - first);
        for (std::uint32_t ring = first; ring < end; ++ring) {
            const auto axis = static_cast<std::size_t>(project.axis());
            const std::int64_t area =
                longest[axis] < 0 ? -normals[ring - first][axis] : normals[ring - first][axis];
            if (area == 0) {
                add_face(ring); // no area: it only carries edges, so it is a face of its own
                continue;
            }
            NestedRing nested{ring, {}, area, 0};
            const Ring corners = solid_.ring(ring);
            nested.polygon.reserve(corners.count);
            for (std::uint32_t i = 0; i < corners.count; ++i) {
                const FlatPoint p = project(solid_.vertices[corners.corners[i]]);
                nested.polygon.push_back({2 * p.u, 2 * p.v});
            }
            rings_.push_back(std::move(nested));
        }
    }

    static std::int64_t length(const Normal& normal) {
        return std::max({magnitude(normal[0]), magnitude(normal[1]), magnitude(normal[2])});
    }

    // The rings around one another may be as many as all of them, so only their number is kept.
    void find_depth(NestedRing& ring) const {
        for (const NestedRing& other : rings_) {
            if (&other != &ring && lies_inside(ring.polygon, other.polygon)) ++ring.depth;
        }
    }

    // Decided by the first corner, or else middle of an edge, that is not on the other ring.
    bool lies_inside(const std::vector<FlatPoint>& polygon, const std::vector<FlatPoint>& other) const {
        for (const FlatPoint& corner : polygon) {
            const Side side = side_of(other, corner);
            if (side != Side::on) return side == Side::inside;
        }
        FlatPoint previous = polygon.back();
        for (const FlatPoint& corner : polygon) {
            const Side side = side_of(other, {(previous.u + corner.u) / 2, (previous.v + corner.v) / 2});
            if (side != Side::on) return side == Side::inside;
            previous = corner;
        }
        throw BadInput("two polygons of facet " + std::to_string(facet_) + " (counted from 0) coincide");
    }

    void add_ring(std::uint32_t r, bool reversed) {
        const Ring ring = solid_.ring(r);
        auto& corners = faces_.corners;
        const auto start = static_cast<std::ptrdiff_t>(corners.size());
        corners.insert(corners.end(), ring.corners, ring.corners + ring.count);
        if (reversed) std::reverse(corners.begin() + start, corners.end());
        faces_.end_ring();
    }

    void add_face(std::uint32_t ring) {
        add_ring(ring, false);
        faces_.end_face();
    }

    void add_face_with_holes(const NestedRing& outline) {
        add_ring(outline.ring, outline.area < 0);
        for (const NestedRing& nested : rings_) {
            if (nested.depth == outline.depth + 1 && lies_inside(nested.polygon, outline.polygon)) {
                add_ring(nested.ring, nested.area > 0);
            }
        }
        faces_.end_face();
    }

    const Solid& solid_;
    std::uint32_t facet_;
    FaceTable& faces_;
    std::vector<NestedRing> rings_;
};

} // namespace

FaceTable nest_rings(const FaceTable& facets, const std::vector<Point>& vertices) {
    const Solid solid{vertices.data(),           static_cast<std::uint32_t>(vertices.size()),
                      facets.corners.data(),     static_cast<std::uint32_t>(facets.corners.size()),
                      facets.ring_starts.data(), facets.face_rings.data(),
                      facets.face_count()};
    FaceTable faces;
    for (std::uint32_t facet = 0; facet < solid.face_count; ++facet) FacetNester(solid, facet, faces)();
    return faces;
}

} // namespace osem::host
