#include "mesh/ring_nesting.hpp"

#include <algorithm>
#include <string>

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
        for (std::size_t i = 0; i < rings_.size(); ++i) find_containers(i);
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            if (!rings_[i].is_hole()) add_face_with_holes(i);
        }
    }

  private:
    struct NestedRing {
        std::uint32_t ring;
        std::vector<FlatPoint> polygon; ///< at twice the scale, so that middles of edges are points too
        std::int64_t area;              ///< twice the signed area, unscaled
        std::vector<std::size_t> containers;
        bool is_hole() const { return containers.size() % 2 == 1; }
    };

    void take_rings(std::uint32_t first, std::uint32_t end) {
        Normal longest{};
        std::vector<Normal> normals;
        for (std::uint32_t ring = first; ring < end; ++ring) {
            normals.push_back(newell_normal(solid_, ring));
            if (length(normals.back()) > length(longest)) longest = normals.back();
        }
        const Projection project(longest);
        for (std::uint32_t ring = first; ring < end; ++ring) {
            const auto axis = static_cast<std::size_t>(project.axis());
            const std::int64_t area =
                longest[axis] < 0 ? -normals[ring - first][axis] : normals[ring - first][axis];
            if (area == 0) {
                add_face(ring); // no area: it only carries edges, so it is a face of its own
                continue;
            }
            NestedRing nested{ring, {}, area, {}};
            const Ring corners = solid_.ring(ring);
            for (std::uint32_t i = 0; i < corners.count; ++i) {
                const FlatPoint p = project(solid_.vertices[corners.corners[i]]);
                nested.polygon.push_back({2 * p.u, 2 * p.v});
            }
            rings_.push_back(nested);
        }
    }

    static std::int64_t length(const Normal& normal) {
        return std::max({magnitude(normal[0]), magnitude(normal[1]), magnitude(normal[2])});
    }

    void find_containers(std::size_t i) {
        for (std::size_t k = 0; k < rings_.size(); ++k) {
            if (k != i && lies_inside(rings_[i].polygon, rings_[k].polygon)) {
                rings_[i].containers.push_back(k);
            }
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

    void add_face_with_holes(std::size_t outline) {
        add_ring(rings_[outline].ring, rings_[outline].area < 0);
        const std::size_t depth = rings_[outline].containers.size();
        for (const NestedRing& nested : rings_) {
            const auto& in = nested.containers;
            if (in.size() == depth + 1 && std::find(in.begin(), in.end(), outline) != in.end()) {
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
