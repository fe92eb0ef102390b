// Trees that fit the memory at hand: the finest conversion that a pool has room for, and the best tree of so
// many nodes that still holds what another one certifies.
#ifndef OSEM_FIT_HPP
#define OSEM_FIT_HPP

#include <cstdint>

#include "osem/convert.hpp"
#include "osem/octree.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

/// Outcome of a fitting; built.tree.depth is the depth that fitted.
struct FitOutcome {
    TreeOutcome built;
    std::uint64_t octants_visited; ///< in all passes
};

/// Converts at the finest depth, up to a limit, whose tree fits the free nodes of a pool. Counting passes go
/// from the limit downwards, each given up as soon as its count is above what is free; the first that ends
/// is followed by the pass that writes.
///
/// The number of nodes is not monotone in the depth, whatever the leaf rule: a wall between two touching
/// parts, in a plane of the finer octants, costs boundary leaves until the depth that resolves it and nothing
/// from there on; centre leaves miss at one depth what they hit at the one before. So a bisection could stop
/// at a coarser depth than need be, and "finest" means that every greater depth up to the limit needs more
/// nodes than are free. A tree of depth 1 takes no node from a pool: some depth always fits.
class Fitting {
  public:
    /// Starts; options.depth is the limit. Scratch: convert_scratch(solid.view()) indices, in use until
    /// finish. Nothing else may append to the pool until then. A fitting that was not finished is given up
    /// first. Status: ok; depth_out_of_range; scratch_too_small. When not ok, nothing has begun.
    Status begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                 std::uint32_t scratch_size, NodePool& pool);

    /// Visits up to `octants` octants; false when nothing is left. Cost of a visit: as Conversion::step.
    /// Passes: at most options.depth and one.
    bool step(std::uint32_t octants);

    /// The depth of the pass under way, or of the tree.
    int depth() const { return options_.depth; }
    /// Whether the pass under way writes.
    bool writing() const { return writing_; }
    /// As those of Conversion, for the pass under way.
    std::uint64_t decided_volume() const { return conversion_.decided_volume(); }
    std::uint64_t octants_visited() const { return conversion_.octants_visited(); }
    const StageCounts& stages() const { return conversion_.stages(); }

    /// The tree. Called before step has returned false it gives the fitting up. Status: ok; unfinished.
    /// When not ok the pool is as it was at begin.
    FitOutcome finish();

  private:
    void next_pass(bool fits);

    CheckedSolid solid_ = CheckedSolid::vouched(Solid{});
    ConvertOptions options_ = {0, LeafRule::conservative, WindingRule::nonzero};
    std::uint32_t* scratch_ = nullptr;
    NodePool* pool_ = nullptr;
    std::uint64_t visited_ = 0; ///< in the passes before this one
    bool writing_ = false;
    bool running_ = false;
    Conversion conversion_;
};

/// Fits in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working memory.
FitOutcome fit(Fitting& job, const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
               std::uint32_t scratch_size, NodePool& pool);

/// What the nodes of a subtree are worth when keeping a node has a price: the part of Pruning that looks.
/// An octant is given up when the cells known in it (black or white) are at most the price of its node and
/// what its children cost, each at its best.
class Appraisal {
  public:
    /// Starts at a node of `pool` (which may be null for a node without grey children) that divides an octant
    /// of level `level`. Preconditions: price <= 2^57; level < max_depth.
    void begin(const NodePool* pool, const Node& node, int level, std::uint64_t price);

    /// Goes on to the next node; false when the subtree has been seen.
    bool step();

    /// Afterwards: of the octants below the starting node, what is best kept and what that costs, a price for
    /// each node kept and a cell for each known cell given up.
    std::uint64_t kept_below() const { return frames_[0].kept; }
    std::uint64_t cost_below() const { return frames_[0].cost; }
    /// Nodes kept when the starting node may be given up as well; 0 when it is.
    std::uint64_t kept() const { return is_given_up(frames_[0]) ? 0 : frames_[0].kept + 1; }
    std::uint64_t known() const { return frames_[0].known; } ///< cells that are black or white
    std::uint64_t black() const { return black_; }           ///< cells that are black

  private:
    struct Frame {
        Node node;
        std::uint8_t left;   ///< grey children not yet seen
        std::uint64_t known; ///< at most 2^60
        std::uint64_t cost;  ///< of the children seen; at most known
        std::uint64_t kept;  ///< at most 8^19 = 2^57
    };
    void enter(const Node& node);
    bool is_given_up(const Frame& frame) const { return frame.known <= price_ + frame.cost; }

    const NodePool* pool_ = nullptr;
    std::uint64_t price_ = 0;
    std::uint64_t black_ = 0;
    int top_level_ = 0;
    int at_ = 0; ///< the frame on top
    Frame frames_[max_depth] = {};
};

/// Outcome of a pruning. Volumes are in cells of side 1; the root holds 2^60.
struct PruneOutcome {
    TreeOutcome built;           ///< nodes_needed: at most the budget
    std::uint64_t inner_lost;    ///< cells that were black and are boundary
    std::uint64_t outer_gained;  ///< cells that were white and are boundary
    std::uint64_t above_optimum; ///< no tree within the budget loses less than the sum of the two by more
                                 ///< than this; 0: this one loses least
};

/// Coarsens a tree to a node budget: octants are given up, and become boundary leaves, such that few cells
/// lose their colour. A black leaf of the result is black in the tree throughout, a white one white: the
/// result's inner solid is within the tree's, its outer solid holds the tree's. With a budget of 0 the top
/// node is left.
///
/// Giving up a set of octants loses their known cells (black or white) and saves their nodes. For a price of
/// a node in cells the best set is found exactly, bottom up; with a rising price octants are only ever given
/// up. The least price that meets the budget is bisected. Then room left over goes, in Morton order, to
/// octants that a price lower by 1 would have kept: whole where they fit, else in part. Every set that the
/// budget allows loses at least (least cost at the price) - price x budget, whence above_optimum.
/// Source: cost-complexity pruning, Breiman, Friedman, Olshen and Stone, "Classification and Regression
/// Trees" (1984), chapter 3; as a Lagrangian bound, Everett, Operations Research 11(3), 1963.
class Pruning {
  public:
    /// Starts. The result goes to `pool`, the tree's own or another one; with a null pool this is a counting
    /// pass. `budget` is for the nodes that the result takes from a pool: the top node is not among them, and
    /// nothing is shared with the operand. Nodes of the operand count as often as they are reached.
    /// The budget for what a pool has free: pool.capacity() - pool.used().
    /// Between begin and finish nothing else may append to the pool. A pruning that was not finished is given
    /// up first.
    void begin(const Octree& tree, std::uint32_t budget, NodePool* pool);

    /// Visits up to `nodes` nodes; false when nothing is left. Visits in all: at most
    /// (59 + 2 depth) x nodes of the tree, and depth x nodes of the result.
    bool step(std::uint32_t nodes);

    /// Nodes visited so far.
    std::uint64_t nodes_visited() const { return visited_; }

    /// The result. Called before step has returned false it gives the pruning up. Status: ok; pool_exhausted
    /// when the pool has fewer free nodes than the result takes; unfinished. When not ok the pool is as it
    /// was at begin.
    PruneOutcome finish();

  private:
    enum class Phase : std::uint8_t { bisecting, settling, writing };
    /// Which nodes of a subtree are kept.
    enum class Rule : std::uint8_t {
        paid,      ///< those that the price keeps; where it keeps none, loose
        loose,     ///< as many as there is room for
        all_cheap, ///< those that a price lower by 1 keeps
    };
    struct Frame {
        Node node;
        std::uint8_t left; ///< grey children not yet decided
        Rule rule;
    };
    void appraised();
    void choose_price(std::uint64_t kept);
    void start_writing();
    void write();
    void ask(bool cheap);
    void decide();
    void decide_favour(std::uint64_t kept);
    bool take_room(std::uint64_t nodes);
    void enter(const Node& node, Rule rule);
    void keep(Rule rule);
    void give_up();
    const Node& child() const;

    Octree tree_ = {};
    std::uint64_t visited_ = 0;
    std::uint64_t too_low_ = 0; ///< a price that keeps too many
    std::uint64_t enough_ = 0;  ///< one that does not
    std::uint64_t price_ = 0;
    std::uint64_t least_loss_ = 0; ///< of any set within the budget
    std::uint64_t inner_lost_ = 0;
    std::uint64_t outer_gained_ = 0;
    std::uint32_t budget_ = 0;
    std::uint64_t room_ = 0; ///< nodes of the budget not yet spoken for
    Phase phase_ = Phase::bisecting;
    bool asking_ = false; ///< the appraisal is under way
    bool cheap_ = false;  ///< it is at the price lower by 1
    int level_ = 0;
    Frame frames_[max_depth] = {};
    Appraisal appraisal_;
    TreeBuilder builder_;
};

/// Prunes in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
PruneOutcome prune(Pruning& job, const Octree& tree, std::uint32_t budget, NodePool* pool);

} // namespace osem

#endif
