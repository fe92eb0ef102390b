// Ear clipping: O'Rourke, "Computational Geometry in C", section 1.4, on the cycles of a face.
#include "mesh/triangulate.hpp"

#include <deque>

#include "mesh/face_cycles.hpp"
#include "mesh/hole_bridges.hpp"

namespace osem::host {

namespace {

// Cuts a cycle into triangles. A corner a, b, c may be clipped when it turns left and no other corner lies
// in its triangle. A cycle of a planar face always has one; where rounding has made a bent face cross
// itself there may be none, and then the smallest corner goes: whatever is clipped, the triangle and the
// shorter cycle together have the boundary of the longer one.
class EarClipper {
  public:
    EarClipper(FaceCycles& cycles, std::uint32_t head, std::vector<Triangle>& triangles)
        : cycles_(cycles), triangles_(triangles), state_(cycles.nodes.size(), State::gone) {
        std::uint32_t node = head;
        do {
            corners_.push_back(node);
            state_[node] = turn(node) > 0 ? State::convex : State::blocking;
            if (state_[node] == State::blocking) blocking_.push_back(node);
        } while ((node = next(node)) != head);
        left_ = corners_.size();
        candidates_.assign(corners_.begin(), corners_.end());
    }

    void operator()() {
        while (left_ > 3) {
            const std::uint32_t ear = next_ear();
            clip(ear);
        }
        if (left_ == 3) clip(remaining());
    }

  private:
    // A corner that turns left cannot lie in another's triangle unless one that does not also lies there.
    enum class State : unsigned char { gone, convex, blocking };

    // Full searches after the candidates ran out; a bent face could need one for every ear, which would
    // make the whole cubic.
    static constexpr int most_searches = 64;

    std::uint32_t previous(std::uint32_t node) const { return cycles_.nodes[node].previous; }
    std::uint32_t next(std::uint32_t node) const { return cycles_.nodes[node].next; }
    std::uint32_t vertex(std::uint32_t node) const { return cycles_.nodes[node].vertex; }

    std::int64_t turn(std::uint32_t node) const {
        return orient(cycles_.point(previous(node)), cycles_.point(node), cycles_.point(next(node)));
    }

    // The first corner left.
    std::uint32_t remaining() const {
        std::size_t i = 0;
        while (state_[corners_[i]] == State::gone) ++i;
        return corners_[i];
    }

    std::uint32_t next_ear() {
        for (;;) {
            while (!candidates_.empty()) {
                const std::uint32_t node = candidates_.front();
                candidates_.pop_front();
                if (state_[node] != State::gone && is_ear(node)) return node;
            }
            if (searched_in_vain_ || searches_ == most_searches) break;
            ++searches_;
            searched_in_vain_ = true; // until something is clipped
            for (const std::uint32_t node : corners_) {
                if (state_[node] != State::gone) candidates_.push_back(node);
            }
        }
        return smallest();
    }

    bool is_ear(std::uint32_t node) {
        if (turn(node) <= 0) return false;
        for (std::size_t i = 0; i < blocking_.size();) {
            const std::uint32_t other = blocking_[i];
            if (state_[other] != State::blocking) {
                blocking_[i] = blocking_.back();
                blocking_.pop_back();
                continue;
            }
            if (blocks(other, node)) return false;
            ++i;
        }
        return true;
    }

    // Corners on the same vertices as the ear's do not block it: their edges would have to enter the
    // triangle and end in it.
    bool blocks(std::uint32_t other, std::uint32_t node) const {
        const std::uint32_t a = previous(node);
        const std::uint32_t c = next(node);
        if (vertex(other) == vertex(a) || vertex(other) == vertex(node) || vertex(other) == vertex(c)) {
            return false;
        }
        const FlatPoint& p = cycles_.point(other);
        return orient(cycles_.point(a), cycles_.point(node), p) >= 0 &&
               orient(cycles_.point(node), cycles_.point(c), p) >= 0 &&
               orient(cycles_.point(c), cycles_.point(a), p) >= 0;
    }

    std::uint32_t smallest() const {
        std::uint32_t best = remaining();
        for (const std::uint32_t node : corners_) {
            if (state_[node] != State::gone && magnitude(turn(node)) < magnitude(turn(best))) best = node;
        }
        return best;
    }

    void remove(std::uint32_t node) {
        cycles_.nodes[previous(node)].next = next(node);
        cycles_.nodes[next(node)].previous = previous(node);
        state_[node] = State::gone;
        --left_;
    }

    void clip(std::uint32_t node) {
        const std::uint32_t a = previous(node);
        const std::uint32_t c = next(node);
        remove(node);
        if (vertex(a) == vertex(c)) {
            remove(c); // a spike: its two edges cancel
        } else {
            const auto& names = cycles_.names;
            triangles_.push_back({names[vertex(a)], names[vertex(node)], names[vertex(c)]});
        }
        searched_in_vain_ = false;
        refresh(a);
        refresh(next(a));
    }

    void refresh(std::uint32_t node) {
        const State before = state_[node];
        state_[node] = turn(node) > 0 ? State::convex : State::blocking;
        if (before == State::convex && state_[node] == State::blocking) blocking_.push_back(node);
        candidates_.push_back(node);
    }

    FaceCycles& cycles_;
    std::vector<Triangle>& triangles_;
    std::vector<std::uint32_t> corners_;
    std::vector<State> state_;
    std::vector<std::uint32_t> blocking_; ///< all blocking corners, and some that no longer are
    std::deque<std::uint32_t> candidates_;
    std::size_t left_ = 0;
    int searches_ = 0;
    bool searched_in_vain_ = false;
};

} // namespace

std::vector<Triangle> triangulate_face(const Solid& solid, std::uint32_t face) {
    std::vector<Triangle> triangles;
    FaceCycles cycles = face_cycles(solid, face, triangles);
    bridge_holes(cycles);
    for (const std::uint32_t head : cycles.heads) EarClipper(cycles, head, triangles)();
    return triangles;
}

} // namespace osem::host
