// Segments and rays through a tree: the leaves met one after the other, and where exactly.
//
// Crossings of axis-parallel planes are met in the order of their parameters, as in Revelles, Urena and
// Lastra, "An Efficient Parametric Algorithm for Octree Traversal" (2000). Parameters are rational numbers
// and compared by cross-multiplication, so nothing is divided and nothing rounded.
#ifndef OSEM_RAY_HPP
#define OSEM_RAY_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/query.hpp"
#include "osem/status.hpp"

namespace osem {

/// A segment's ends may have coordinates in [-segment_reach, segment_reach], 2^29 lattice units: so a ray of
/// any direction can begin and end far outside the root.
constexpr std::int32_t segment_reach = std::int32_t{1} << 29;

/// A directed segment between two lattice points, which may be the same. What is walked along is the segment
/// moved by (e, e^2, e^3), e > 0 infinitesimal, like the reference points of a conversion: it never runs in a
/// face or an edge, crosses one face at a time, begins in the cell that has `from` as its minimum corner and
/// ends in that of `to`. Where the segment itself runs in a face the leaf on the face's high side is met;
/// where it passes an edge or a corner, leaves that it touches in one point may be met, with their entry
/// equal to their exit. The root is half-open, like its leaves: of a segment in its face at 0 leaves are met,
/// of one in its face at 2^20 none. The reversed segment meets the same leaves in reverse order.
struct Segment {
    Point from;
    Point to;
};

/// The segment from a point towards a direction, ended far outside the root: its difference is the direction
/// times the greatest power of two that keeps it in the range of segments. Preconditions: the coordinates of
/// both are in [-2^28, 2^28]. With a direction of (0, 0, 0) the segment is the point.
Segment ray(const Point& from, const Point& direction);

/// A place along a segment: from + t * (to - from), t = numerator / denominator in [0, 1].
struct Parameter {
    std::int32_t numerator;   ///< in [0, denominator]
    std::int32_t denominator; ///< in [1, 2^30]; at a face it is |to - from| along the face's axis

    friend constexpr bool operator<(const Parameter& a, const Parameter& b) {
        return std::int64_t{a.numerator} * b.denominator < std::int64_t{b.numerator} * a.denominator;
    }
    friend constexpr bool operator==(const Parameter& a, const Parameter& b) { return !(a < b) && !(b < a); }
    friend constexpr bool operator!=(const Parameter& a, const Parameter& b) { return !(a == b); }
};

/// The part of a segment in one leaf.
struct Passage {
    Leaf leaf;
    Parameter entry;   ///< 0 / 1 where the segment begins in the leaf
    Parameter exit;    ///< 1 / 1 where it ends in the leaf
    bool begins;       ///< the segment begins in the leaf; else it has entered by a face
    bool ends;         ///< the segment ends in the leaf; else it goes on, through a face
    Axis entered_axis; ///< of the face of entry; without meaning when begins
    Axis left_axis;    ///< of the face of exit; without meaning when ends
};

/// A face at which the colour changes. Around the root all is white.
struct Crossing {
    Parameter at;
    Axis axis;     ///< of the face; it is entered in the direction of the segment along that axis
    Colour before; ///< of the leaf left
    Colour after;  ///< of the leaf entered
    Leaf entered;  ///< the leaf entered; behind the root the root octant, as white
};

/// A walk along a segment, resumable after any leaf; O(depth) state.
class SegmentWalk {
  public:
    /// Status: ok; coordinate_out_of_range when a coordinate is outside the range of segments. A refused walk
    /// meets nothing. Cost: O(1).
    SegmentWalk(const Octree& tree, const Segment& segment);
    Status status() const { return status_; }

    /// Takes the next leaf met; false when there is none. Cost: O(depth), and over the whole walk the nodes
    /// visited.
    bool next(Passage& passage);

    /// Goes on to the next change of colour, past the leaves in between; false when there is none. Where the
    /// segment begins in the root its first leaf's colour is no change. May be mixed with next: a change
    /// counts from the leaf last taken.
    bool next_crossing(Crossing& crossing);

    /// Nodes visited so far. In all at most depth for each leaf met.
    std::uint32_t visited() const { return visited_; }

  private:
    enum class State : std::uint8_t { before_root, in_leaf, done };
    struct Plane {
        std::int32_t numerator; ///< of the parameter at which the segment crosses it
        std::uint8_t axis;
    };
    bool before(const Plane& a, const Plane& b) const;
    Parameter parameter(const Plane& plane) const { return {plane.numerator, length_[plane.axis]}; }
    std::int32_t end_cell(unsigned axis) const { return start_cell_[axis] + length_[axis]; }
    Octant octant() const;
    bool enter_root();
    void enter_leaf(unsigned level, std::int32_t known);
    void take_leaf(unsigned level, Colour colour);
    bool cross();

    const NodePool* pool_;
    Node top_;
    Status status_;
    State state_ = State::done;
    std::uint8_t mirror_ = 0; ///< bit a is set when the segment descends along axis a: it is seen in a mirror
    std::uint8_t rank_[3];    ///< the order in which planes of the axes are crossed at one parameter
    bool begins_ = true;
    bool ends_ = false;
    // All that follows is as seen in the mirror, where the segment ascends along every axis.
    std::int32_t start_[3];
    std::int32_t start_cell_[3]; ///< of the moved start
    std::int32_t length_[3];
    std::int32_t at_[3]; ///< the leaf's minimum corner; along an axis of length 0 the segment's cell
    Plane entry_ = {0, 0};
    Plane exit_ = {0, 0};
    Colour colour_ = Colour::white; ///< of the leaf last taken
    std::uint8_t level_ = 0;
    std::uint32_t visited_ = 0;
    const Node* path_[max_depth];
};

/// Outcome of a search along a segment.
struct HitOutcome {
    Status status;
    bool hit;
    Passage passage; ///< through the first leaf of a colour asked for; without meaning when there is no hit
    std::uint32_t visited;
};

/// The first leaf along a segment whose colour is in a set; with solid_colours, the first that may be solid.
/// Status and cost are the walk's.
HitOutcome first_hit(const Octree& tree, const Segment& segment, std::uint8_t colours = solid_colours);

} // namespace osem

#endif
