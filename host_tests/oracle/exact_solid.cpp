#include "exact_solid.hpp"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace oracle {

namespace {

using Triangles = std::vector<Triangle3>;
using Segments = std::vector<Segment3>;
template <class Primitive>
using TreeOf = CGAL::AABB_tree<CGAL::AABB_traits<Exact, Primitive>>;
using TriangleTree = TreeOf<CGAL::AABB_triangle_primitive<Exact, Triangles::const_iterator>>;
using SegmentTree = TreeOf<CGAL::AABB_segment_primitive<Exact, Segments::const_iterator>>;

// Ways out of the root octant: each is longer than the root along one axis. The small components are primes
// without meaning, so that a way rarely runs through an edge or along a plane; when it does, the next one is
// taken. They are tried in a fixed order, so every run is the same.
constexpr int way_count = 12;
constexpr std::array<std::array<int, 3>, way_count> ways = {{
    {2097169, 104729, 51977},
    {-2097211, 75781, -30011},
    {61403, 2097223, -99551},
    {-20011, -2097253, 47629},
    {88811, 33331, 2097257},
    {-44449, 70001, -2097287},
    {2097289, -60013, 1000003},
    {-2097311, -900007, 12347},
    {700001, 2097353, 500009},
    {-300007, -2097421, -650011},
    {810013, -710009, 2097427},
    {-510007, 920011, -2097457},
}};

bool strictly_crosses(const Triangle3& t, const Point3& p, const Point3& q) {
    const CGAL::Orientation first = CGAL::orientation(p, q, t[0], t[1]);
    return first != CGAL::COPLANAR && CGAL::orientation(p, q, t[1], t[2]) == first &&
           CGAL::orientation(p, q, t[2], t[0]) == first;
}

} // namespace

struct ExactSolid::Trees {
    Triangles triangles;
    std::vector<int> windings;
    Segments segments;
    TriangleTree triangle_tree;
    SegmentTree segment_tree;

    std::optional<int> winding_along(const Point3& p, const Point3& q) const;
};

ExactSolid::ExactSolid(const osem::Solid& solid) : trees_(std::make_unique<Trees>()) {
    for (std::uint32_t f = 0; f < solid.face_count; ++f) {
        FacePieces pieces = pieces_of(solid, f);
        for (const WoundTriangle& t : pieces.triangles) {
            trees_->triangles.push_back(t.shape);
            trees_->windings.push_back(t.winding);
        }
        trees_->segments.insert(trees_->segments.end(), pieces.segments.begin(), pieces.segments.end());
    }
    trees_->triangle_tree.insert(trees_->triangles.cbegin(), trees_->triangles.cend());
    trees_->segment_tree.insert(trees_->segments.cbegin(), trees_->segments.cend());
    trees_->triangle_tree.build();
    trees_->segment_tree.build();
}

ExactSolid::~ExactSolid() = default;

bool ExactSolid::meets_open(const osem::Octant& octant) const {
    const osem::Point& low = octant.corner;
    const int side = octant.side();
    const CGAL::Bbox_3 box(low.x(), low.y(), low.z(), low.x() + side, low.y() + side, low.z() + side);
    std::vector<TriangleTree::Primitive_id> triangles;
    if (!trees_->triangle_tree.empty()) {
        trees_->triangle_tree.all_intersected_primitives(box, std::back_inserter(triangles));
    }
    for (const auto& t : triangles) {
        if (oracle::meets_open(*t, octant)) return true;
    }
    std::vector<SegmentTree::Primitive_id> segments;
    if (!trees_->segment_tree.empty()) {
        trees_->segment_tree.all_intersected_primitives(box, std::back_inserter(segments));
    }
    for (const auto& s : segments) {
        if (oracle::meets_open(*s, octant)) return true;
    }
    return false;
}

// Nothing when the way touches a triangle otherwise than through its open inside.
std::optional<int> ExactSolid::Trees::winding_along(const Point3& p, const Point3& q) const {
    std::vector<TriangleTree::Primitive_id> hits;
    triangle_tree.all_intersected_primitives(Segment3(p, q), std::back_inserter(hits));
    int winding = 0;
    for (const auto& hit : hits) {
        const Triangle3& t = *hit;
        const CGAL::Orientation from = CGAL::orientation(t[0], t[1], t[2], p);
        const CGAL::Orientation to = CGAL::orientation(t[0], t[1], t[2], q);
        if (from == CGAL::COPLANAR && to != CGAL::COPLANAR) throw std::logic_error("a point on the surface");
        if (from * to != CGAL::NEGATIVE || !strictly_crosses(t, p, q)) return std::nullopt;
        const int weight = windings[static_cast<std::size_t>(hit - triangles.cbegin())];
        winding += to == CGAL::POSITIVE ? weight : -weight;
    }
    return winding;
}

int ExactSolid::winding(const Point3& p) const {
    if (trees_->triangle_tree.empty()) return 0;
    for (const auto& way : ways) {
        const Point3 q = p + Exact::Vector_3(way[0], way[1], way[2]);
        if (const std::optional<int> winding = trees_->winding_along(p, q)) return *winding;
    }
    throw std::logic_error("every way out of the root is degenerate");
}

Point3 centre_of(const osem::Octant& octant) {
    const FT half = FT(octant.side()) / FT(2);
    return {octant.corner.x() + half, octant.corner.y() + half, octant.corner.z() + half};
}

Point3 perturbed_centre_of(const osem::Octant& octant) {
    const int half = octant.side() / 2;
    return {FT(octant.corner.x() + half) + FT(std::ldexp(1.0, -100)),
            FT(octant.corner.y() + half) + FT(std::ldexp(1.0, -200)),
            FT(octant.corner.z() + half) + FT(std::ldexp(1.0, -300))};
}

} // namespace oracle
