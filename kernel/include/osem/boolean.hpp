// Boolean operators on octrees.
#ifndef OSEM_BOOLEAN_HPP
#define OSEM_BOOLEAN_HPP

#include <cstdint>

#include "osem/octree.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

enum class Operator : std::uint8_t { unite, intersect, subtract, exclusive_or };

/// A Boolean in progress: begin, step until done, finish; holds all of its state, O(depth). The operands are
/// read only and share what they can with the result; between begin and finish nothing else may append to
/// the pool. Colours follow Kleene's three-valued logic, boundary being unknown: the result's black leaves
/// are inside and its white ones outside the exact combination, whatever is inside the boundary leaves.
/// On trees without boundary leaves the result is exact.
class Combination {
  public:
    /// Starts `a op b` into the operands' pool, or a counting pass. The result's depth is the greater one.
    /// A combination that was not finished is given up first. Status: ok; pools_differ.
    Status begin(Operator op, const Octree& a, const Octree& b, NodePool& pool, bool count_only = false);

    /// Visits up to `nodes` pairs of nodes; false when none is left. Pairs visited in all: at most the
    /// octants in which both operands have nodes, or one has nodes and the other a leaf that neither decides
    /// alone nor leaves the nodes as they are: a boundary leaf, but in exclusive_or, where it decides; in
    /// subtract and exclusive_or a black one.
    bool step(std::uint32_t nodes);

    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the root's volume (2^60 cells) is decided.
    std::uint64_t decided_volume() const;

    /// Pairs of nodes visited so far; begin visits the first, that of the two root octants.
    std::uint64_t nodes_visited() const { return visited_; }

    /// The result; as Conversion::finish. Status: ok; pool_exhausted; unfinished. When not ok pool and
    /// operands are as they were at begin.
    TreeOutcome finish();

  private:
    struct Frame {
        Node a;
        Node b;
        std::uint8_t left; ///< children still to be combined
    };
    void combine_children(const Node& a, const Node& b, unsigned child);
    void enter(const Node& a, const Node& b);
    bool is_common(const Node& a, const Node& b) const;
    const Node& child_of(const Node& node, unsigned child) const;

    NodePool* pool_ = nullptr;
    Operator op_ = Operator::unite;
    bool complement_b_ = false;
    std::uint8_t depth_ = 0;
    int level_ = 0;
    std::uint64_t visited_ = 0;
    Frame frames_[max_depth] = {};
    TreeBuilder builder_;
};

/// Combines in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
TreeOutcome combine(Combination& job, Operator op, const Octree& a, const Octree& b, NodePool& pool);

/// The complement in the root octant: white and black swap, boundary stays. As combine; its cost is O(nodes).
TreeOutcome complement(Combination& job, const Octree& a, NodePool& pool);

} // namespace osem

#endif
