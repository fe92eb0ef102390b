// Whether two trees, one of them moved, collide, touch, or keep clear of each other.
//
// The trees are gone down together, through the pairs of octants that overlap: after Samet, "Foundations of
// Multidimensional and Metric Data Structures" (2006), on spatial joins of tree structures.
#ifndef OSEM_COLLIDE_HPP
#define OSEM_COLLIDE_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem {

/// How two trees meet, the weaker kinds first. The outer solid is the black and the boundary leaves, the
/// inner one the black leaves alone.
enum class Contact : std::uint8_t {
    clear,    ///< the closed outer solids have no point in common
    touch,    ///< they have, but only on their faces, edges or corners: no cell is in both
    possible, ///< a cell is in both outer solids, but none in both inner ones: they may collide
    certain   ///< a cell is in both inner solids: they collide
};

/// Outcome of a collision query.
struct CollisionOutcome {
    Status status;
    Contact contact;
    Leaf a;                ///< the first pair of leaves found to meet so; without meaning when clear
    Leaf b;                ///< in b's own root, not moved
    std::uint64_t visited; ///< pairs of octants visited
};

/// A collision query in progress: begin, step until done, finish; holds all of its state, O(depth). The trees
/// are read only and may live in different pools.
class Collision {
  public:
    /// Starts the query of a against b moved by `offset` lattice units, any numbers: cell c of b is compared
    /// with cell c + offset of a. Cells of b outside a's root meet nothing.
    void begin(const Octree& a, const Octree& b, const Point& offset);

    /// Visits up to `pairs` pairs of octants; false when none is left, or a certain collision is found. Pairs
    /// visited in all: at most those of octants, divided in a tree or leaves that hold solid, of which b's,
    /// moved, has a cell in a's or beside it; a pair in which both are leaves is judged with the one above.
    bool step(std::uint32_t pairs);

    /// The strongest contact found so far.
    Contact contact() const { return outcome_.contact; }

    /// Pairs of octants visited so far.
    std::uint64_t pairs_visited() const { return outcome_.visited; }

    /// The answer. Status: ok; unfinished, with the strongest contact so far, which is then a lower bound.
    CollisionOutcome finish() const { return outcome_; }

  private:
    struct Side {
        const NodePool* pool;
        Octant octant;            ///< the one reached
        Node path[max_depth + 1]; ///< the nodes down to it; that of a leaf is uniform
        const Node& node() const { return path[octant.level]; }
        void enter(unsigned child);
    };
    struct Frame {
        bool of_b;         ///< whose octant is divided
        std::uint8_t left; ///< its children still to be entered
    };
    bool advance();
    void visit();
    void leave();
    void judge(bool of_b, std::uint8_t inside, std::uint8_t around);
    void note(Contact contact, bool of_b, std::uint8_t children);
    std::uint8_t hopeful(const Node& node) const;
    std::uint8_t children_at(bool of_b, std::int32_t margin) const;
    Side& side(bool of_b) { return of_b ? b_ : a_; }

    Side a_ = {};
    Side b_ = {};
    Point offset_ = {{0, 0, 0}};
    CollisionOutcome outcome_ = {Status::unfinished, Contact::clear, {}, {}, 0};
    bool running_ = false;
    bool fresh_ = false; ///< the roots are still to be visited
    std::uint8_t frame_count_ = 0;
    Frame frames_[2 * max_depth] = {};
};

/// Asks in one call: begin, step to the end, finish. `job` is the working memory.
CollisionOutcome collide(Collision& job, const Octree& a, const Octree& b, const Point& offset);

} // namespace osem

#endif
