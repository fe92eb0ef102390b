#include "mesh/hole_bridges.hpp"

#include <algorithm>
#include <utility>

namespace osem::host {

namespace {

constexpr std::uint32_t none = UINT32_MAX;

class HoleBridger {
  public:
    explicit HoleBridger(FaceCycles& cycles) : cycles_(cycles) {}

    void operator()() {
        std::vector<std::uint32_t> holes;
        std::vector<std::uint32_t> outlines;
        for (const std::uint32_t head : cycles_.heads) {
            if (doubled_area(head) > 0) {
                outlines.push_back(head);
                activate(head);
            } else {
                holes.push_back(rightmost(head));
            }
        }
        // From the right: whatever a hole sees to its right is then bridged already.
        std::sort(holes.begin(), holes.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return more_right(a, b); });
        for (const std::uint32_t hole : holes) {
            const std::uint32_t corner = visible_corner(hole);
            if (corner == none) {
                outlines.push_back(hole);
                continue;
            }
            activate(hole);
            bridge(corner, hole);
        }
        cycles_.heads = outlines;
    }

  private:
    const FlatPoint& at(std::uint32_t node) const { return cycles_.point(node); }
    std::uint32_t next(std::uint32_t node) const { return cycles_.nodes[node].next; }

    void activate(std::uint32_t head) {
        std::uint32_t node = head;
        do {
            active_.push_back(node);
        } while ((node = next(node)) != head);
    }

    std::int64_t doubled_area(std::uint32_t head) const {
        std::int64_t sum = 0;
        for (std::uint32_t node = next(head); node != head; node = next(node)) {
            sum += orient(at(head), at(node), at(next(node)));
        }
        return sum;
    }

    bool more_right(std::uint32_t a, std::uint32_t b) const {
        if (at(a).u != at(b).u) return at(a).u > at(b).u;
        return at(a).v != at(b).v ? at(a).v > at(b).v : a < b;
    }

    // Of several corners at the rightmost vertex the one whose sector opens to the right.
    std::uint32_t rightmost(std::uint32_t head) const {
        std::uint32_t best = head;
        for (std::uint32_t node = next(head); node != head; node = next(node)) {
            if (at(node) == at(best) ? opens_towards(node, {at(node).u + 1, at(node).v})
                                     : more_right(node, best)) {
                best = node;
            }
        }
        return best;
    }

    // Whether a point lies in the sector of the face at a corner: left of both its edges, or, at a reflex
    // corner, of one of them.
    bool opens_towards(std::uint32_t node, const FlatPoint& p) const {
        const FlatPoint& before = at(cycles_.nodes[node].previous);
        const FlatPoint& after = at(next(node));
        const bool left_of_arrival = orient(before, at(node), p) > 0;
        const bool left_of_departure = orient(at(node), after, p) > 0;
        return orient(before, at(node), after) > 0 ? left_of_arrival && left_of_departure
                                                   : left_of_arrival || left_of_departure;
    }

    // The ray runs to the right from the hole's rightmost corner, raised by an infinitesimal amount, so it
    // passes no corner. It leaves the face through an edge that runs upwards.
    bool ray_meets(const FlatPoint& start, std::uint32_t node) const {
        const FlatPoint& a = at(node);
        const FlatPoint& b = at(next(node));
        return a.v <= start.v && start.v < b.v && orient(a, b, start) > 0;
    }

    // Of two upward edges with a height in common that do not cross, whether e lies left of f.
    bool left_of(std::uint32_t e, std::uint32_t f) const {
        const bool swapped = at(e).v < at(f).v;
        if (swapped) std::swap(e, f);
        const std::int64_t turn = orient(at(f), at(next(f)), at(e));
        const bool left = turn != 0 ? turn > 0 : orient(at(f), at(next(f)), at(next(e))) > 0;
        return left != swapped;
    }

    std::uint32_t first_edge_met(const FlatPoint& start) const {
        std::uint32_t best = none;
        for (const std::uint32_t node : active_) {
            if (ray_meets(start, node) && (best == none || left_of(node, best))) best = node;
        }
        return best;
    }

    // The ray, the edge it meets and the way to that edge's right end bound a triangle. Of the corners in it
    // the one at the smallest angle to the ray is visible, the nearest of these if there are several.
    std::uint32_t visible_corner(std::uint32_t hole) const {
        const FlatPoint& start = at(hole);
        const std::uint32_t edge = first_edge_met(start);
        if (edge == none) return none;
        const FlatPoint& low = at(edge);
        const FlatPoint& high = at(next(edge));
        const bool above = high.u > low.u;
        const FlatPoint& end = above ? high : low;
        // Turns seen from the ray towards `end` count positive.
        const auto turn = [&](const FlatPoint& p, const FlatPoint& q) {
            return above ? orient(start, p, q) : orient(start, q, p);
        };
        std::uint32_t best = above ? next(edge) : edge;
        for (const std::uint32_t node : active_) {
            const FlatPoint& p = at(node);
            const bool ray_side = above ? p.v > start.v : p.v <= start.v;
            if (!ray_side || p.u <= start.u || orient(low, high, p) < 0 || turn(p, end) < 0) continue;
            const std::int64_t lower = turn(p, at(best));
            const bool nearer =
                p.u < at(best).u ||
                (p.u == at(best).u && magnitude(p.v - start.v) < magnitude(at(best).v - start.v));
            if (lower > 0 || (lower == 0 && nearer)) best = node;
        }
        return corner_open_towards(best, start);
    }

    std::uint32_t corner_open_towards(std::uint32_t corner, const FlatPoint& p) const {
        for (const std::uint32_t node : active_) {
            if (cycles_.nodes[node].vertex == cycles_.nodes[corner].vertex && opens_towards(node, p)) {
                return node;
            }
        }
        return corner;
    }

    std::uint32_t copy(std::uint32_t node) {
        cycles_.nodes.push_back(cycles_.nodes[node]);
        const auto twin = static_cast<std::uint32_t>(cycles_.nodes.size() - 1);
        active_.push_back(twin);
        return twin;
    }

    void join(std::uint32_t node, std::uint32_t follower) {
        cycles_.nodes[node].next = follower;
        cycles_.nodes[follower].previous = node;
    }

    // Corner, around the hole, back to the corner.
    void bridge(std::uint32_t corner, std::uint32_t hole) {
        const std::uint32_t after = next(corner);
        const std::uint32_t last = cycles_.nodes[hole].previous;
        const std::uint32_t hole_again = copy(hole);
        const std::uint32_t corner_again = copy(corner);
        join(corner, hole);
        join(last, hole_again);
        join(hole_again, corner_again);
        join(corner_again, after);
    }

    FaceCycles& cycles_;
    std::vector<std::uint32_t> active_; ///< nodes of outlines and of holes bridged so far
};

} // namespace

void bridge_holes(FaceCycles& cycles) { HoleBridger{cycles}(); }

} // namespace osem::host
