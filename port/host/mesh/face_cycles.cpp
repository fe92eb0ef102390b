#include "mesh/face_cycles.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace osem::host {

namespace {

Normal face_normal(const Solid& solid, std::uint32_t face) {
    Normal sum{};
    for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
        const Normal normal = newell_normal(solid, ring);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += normal[axis];
    }
    return sum;
}

// Numbers the face's vertices and gives its directed edges in those numbers.
std::vector<Edge> take_edges(const Solid& solid, std::uint32_t face, FaceCycles& cycles) {
    const std::uint32_t first = solid.first_corner(solid.first_ring(face));
    const std::uint32_t end = solid.first_corner(solid.end_ring(face));
    auto& names = cycles.names;
    names.assign(solid.corners + first, solid.corners + end);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const Projection project(face_normal(solid, face));
    for (const std::uint32_t vertex : names) cycles.at.push_back(project(solid.vertices[vertex]));

    const auto number = [&names](std::uint32_t vertex) {
        return static_cast<std::uint32_t>(std::lower_bound(names.begin(), names.end(), vertex) -
                                          names.begin());
    };
    std::vector<Edge> edges;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            edges.push_back({number(ring.corners[i]), number(ring.corners[i + 1 == ring.count ? 0 : i + 1])});
        }
    }
    return edges;
}

// Breaks edges at the vertices that lie on them. Edge (a, b) with v on it becomes (a, v), (v, b), which is
// the edge less the boundary of the triangle (a, b, v).
class EdgeBreaker {
  public:
    EdgeBreaker(const FaceCycles& cycles, std::vector<Triangle>& triangles)
        : cycles_(cycles), triangles_(triangles), by_u_(cycles.at.size()) {
        std::iota(by_u_.begin(), by_u_.end(), 0U);
        std::sort(by_u_.begin(), by_u_.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return at(a).u < at(b).u; });
    }

    std::vector<Edge> operator()(const std::vector<Edge>& edges) {
        std::vector<Edge> broken;
        for (const Edge& edge : edges) {
            std::uint32_t from = edge.from;
            for (const std::uint32_t v : vertices_on(edge)) {
                triangles_.push_back({cycles_.names[from], cycles_.names[edge.to], cycles_.names[v]});
                broken.push_back({from, v});
                from = v;
            }
            broken.push_back({from, edge.to});
        }
        return broken;
    }

  private:
    const FlatPoint& at(std::uint32_t vertex) const { return cycles_.at[vertex]; }

    // In order along the edge, without its ends.
    std::vector<std::uint32_t> vertices_on(const Edge& edge) const {
        const FlatPoint a = at(edge.from);
        const FlatPoint b = at(edge.to);
        std::vector<std::uint32_t> found;
        auto it = std::lower_bound(by_u_.begin(), by_u_.end(), std::min(a.u, b.u),
                                   [this](std::uint32_t vertex, std::int32_t u) { return at(vertex).u < u; });
        for (; it != by_u_.end() && at(*it).u <= std::max(a.u, b.u); ++it) {
            const FlatPoint& p = at(*it);
            if (in_box(a, b, p) && orient(a, b, p) == 0 && !(p == a) && !(p == b)) found.push_back(*it);
        }
        const auto key = [&](std::uint32_t vertex) {
            const FlatPoint& p = at(vertex);
            return std::make_tuple(magnitude(p.u - a.u) + magnitude(p.v - a.v), vertex);
        };
        std::sort(found.begin(), found.end(),
                  [&](std::uint32_t x, std::uint32_t y) { return key(x) < key(y); });
        return found;
    }

    const FaceCycles& cycles_;
    std::vector<Triangle>& triangles_;
    std::vector<std::uint32_t> by_u_;
};

// Removes pairs of opposite edges. The result is in order of its lower ends, so depends on the set only.
std::vector<Edge> cancel_opposites(std::vector<Edge> edges) {
    const auto place = [](const Edge& e) {
        return std::make_pair(std::min(e.from, e.to), std::max(e.from, e.to));
    };
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
        return std::make_tuple(place(a), a.from) < std::make_tuple(place(b), b.from);
    });
    std::vector<Edge> kept;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto differs = [&](const Edge& e) { return place(e) != place(*first); };
        const auto end = std::find_if(first, edges.end(), differs);
        const auto turn = std::find_if(first, end, [&](const Edge& e) { return e.from != first->from; });
        const auto pairs = std::min(turn - first, end - turn);
        kept.insert(kept.end(), first + pairs, turn);
        kept.insert(kept.end(), turn + pairs, end);
        first = end;
    }
    return kept;
}

// An edge seen from the vertex it leaves or reaches.
struct Spoke {
    std::int64_t u; ///< direction, away from the vertex
    std::int64_t v;
    std::uint32_t edge;
    bool leaves;

    // Half of the plane in clockwise order from +u; a spoke without length (two vertices of a bent face that
    // are projected onto each other) has one of its own.
    int half() const { return u == 0 && v == 0 ? 0 : v < 0 || (v == 0 && u > 0) ? 1 : 2; }
};

bool clockwise_before(const Spoke& a, const Spoke& b) {
    if (a.half() != b.half()) return a.half() < b.half();
    const std::int64_t turn = a.u * b.v - a.v * b.u;
    return turn != 0 ? turn < 0 : std::make_tuple(a.leaves, a.edge) < std::make_tuple(b.leaves, b.edge);
}

// Joins edges to cycles. At a vertex where several edges arrive, each goes on with the edge that bounds the
// same sector of the face: the next one clockwise, brackets fashion. So rings that touch at a vertex become
// one cycle or fall into several, as the face really does.
class EdgeLinker {
  public:
    EdgeLinker(FaceCycles& cycles, const std::vector<Edge>& edges) : cycles_(cycles), edges_(edges) {}

    void operator()() {
        std::vector<std::vector<Spoke>> spokes(cycles_.at.size());
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const Edge& edge = edges_[i];
            cycles_.nodes.push_back({edge.from, 0, 0});
            spokes[edge.from].push_back(spoke(edge.from, edge.to, i, true));
            spokes[edge.to].push_back(spoke(edge.to, edge.from, i, false));
        }
        for (auto& around : spokes) link(around);
        collect_heads();
    }

  private:
    Spoke spoke(std::uint32_t at, std::uint32_t towards, std::uint32_t edge, bool leaves) const {
        const FlatPoint& a = cycles_.at[at];
        const FlatPoint& b = cycles_.at[towards];
        return {std::int64_t{b.u} - a.u, std::int64_t{b.v} - a.v, edge, leaves};
    }

    void link(std::vector<Spoke>& around) {
        std::sort(around.begin(), around.end(), clockwise_before);
        std::vector<std::uint32_t> arrived;
        std::vector<bool> linked(around.size(), false);
        for (std::size_t i = 0; i < 2 * around.size(); ++i) { // twice, for pairs across the start
            const std::size_t k = i % around.size();
            if (linked[k]) continue;
            if (!around[k].leaves) {
                if (i < around.size()) arrived.push_back(around[k].edge);
            } else if (!arrived.empty()) {
                cycles_.nodes[arrived.back()].next = around[k].edge;
                cycles_.nodes[around[k].edge].previous = arrived.back();
                linked[k] = true;
                arrived.pop_back();
            }
        }
    }

    void collect_heads() {
        std::vector<bool> seen(edges_.size(), false);
        for (std::uint32_t head = 0; head < edges_.size(); ++head) {
            if (seen[head]) continue;
            cycles_.heads.push_back(head);
            for (std::uint32_t node = head; !seen[node]; node = cycles_.nodes[node].next) seen[node] = true;
        }
    }

    FaceCycles& cycles_;
    const std::vector<Edge>& edges_;
};

} // namespace

FaceCycles face_cycles(const Solid& solid, std::uint32_t face, std::vector<Triangle>& triangles) {
    FaceCycles cycles;
    const std::vector<Edge> whole = take_edges(solid, face, cycles);
    const std::vector<Edge> edges = cancel_opposites(EdgeBreaker(cycles, triangles)(whole));
    EdgeLinker(cycles, edges)();
    return cycles;
}

} // namespace osem::host
