// Boundary to octree conversion by a bintree and the labelling of its components: the paper's other
// technique.
#ifndef OSEM_BINTREE_HPP
#define OSEM_BINTREE_HPP

#include <cstdint>

#include "osem/classify.hpp"
#include "osem/convert.hpp"
#include "osem/solid.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

/// Levels of a bintree under the root: three halvings an octree level.
constexpr int max_block_level = 3 * max_depth;

/// A third of a block's level, rounded down: the level of the octant that the block is or is a part of. As a
/// product, because small parts do not divide; exact below 128 (43 / 128 is 1 / 3 + 1 / 384).
constexpr int third_of(int level) { return (level * 43) >> 7; }
/// How many halvings a block is below that octant: 0, 1 or 2.
constexpr int halvings_of(int level) { return level - 3 * third_of(level); }

/// A block of a bintree: the root octant halved `level` times, along z, y, x, z and so on. With this order
/// the blocks in preorder are in the order of octants. Blocks of a level that is a multiple of 3 are octants.
struct Block {
    Point corner; ///< the minimum corner
    std::uint8_t level;

    /// The axis along which the block is halved.
    constexpr Axis axis() const { return static_cast<Axis>(2 - halvings_of(level)); }
    /// Half the block's side along that axis. Precondition: level < max_block_level.
    constexpr std::int32_t half_side() const { return root_side >> (third_of(level) + 1); }
    constexpr std::int32_t side(int along) const {
        return root_side >> (third_of(level) + (halvings_of(level) > 2 - along ? 1 : 0));
    }
    /// The half at the low (0) or the high side (1). Precondition: level < max_block_level.
    constexpr Block half(unsigned high) const {
        Block half = {corner, static_cast<std::uint8_t>(level + 1)};
        if (high != 0) half.corner.at[axis()] += half_side();
        return half;
    }
    /// The block that this one is a half of. Precondition: level > 0.
    constexpr Block parent() const {
        Block whole = {corner, static_cast<std::uint8_t>(level - 1)};
        whole.corner.at[whole.axis()] &= ~whole.half_side();
        return whole;
    }
    /// Whether this is the half at the high side. Precondition: level > 0.
    constexpr bool is_high() const {
        const Block whole = parent();
        return whole.corner.at[whole.axis()] != corner.at[whole.axis()];
    }
};

/// Outcome of a labelling.
struct LabellingOutcome {
    TreeOutcome built;           ///< nodes_needed is 0 when the blocks did not fit
    std::uint32_t blocks_needed; ///< words of scratch for blocks that suffice; if unfinished those so far
    std::uint32_t components;    ///< of the blocks that no face meets
};

/// A conversion by labelling in progress: begin, step until done, finish. The tree is node for node that of
/// Conversion with conservative leaves, at the same places of a pool. (The technique colours what the surface
/// leaves free, so it has no centre leaves.) It holds all state but scratch, so it may be a static object.
///
/// 1. Blocks are halved until no face meets them or they are octants at full depth, which are boundary.
/// 2. Free blocks that share a part of a side are of one component if the winding number is the same on both
///    sides: faces that lie in the side itself meet neither block.
/// 3. The winding number of each component's first block, by a ray through all faces, says whether the
///    component is inside; the blocks are folded into octants.
///
/// Source: Trstenjak, Zalik and Guid, Informatica 2/91, section 2 (boundary conversion into a bintree and
/// labelling, after Samet and Tamminen, "Efficient Component Labeling of Images of Arbitrary Dimension
/// Represented by Linear Bintrees", PAMI 10(4), 1988). There the component outside is white and the rest
/// black, which holds for one shell alone: see kernel/DESIGN.md for what is done instead.
///
/// Scratch for blocks: a word each. How many is known after step 1: at most 2 leaves - 1 for a bintree of so
/// many leaves, of which the result's blocks_needed is the greatest number that stood at once. Two halves
/// that are boundary leaves are one.
class Labelling {
  public:
    /// Starts; with a null pool the nodes are only counted, with `block_size` 0 the blocks.
    /// Scratch: convert_scratch(solid.view()) face indices, and block_size words, both in use until finish.
    /// Nothing else may append to the pool until then. A labelling that was not finished is given up first.
    /// Status: ok; depth_out_of_range, outside [1, 20]; scratch_too_small for the faces. When not ok, nothing
    /// has begun.
    Status begin(const CheckedSolid& solid, int depth, WindingRule winding, std::uint32_t* faces,
                 std::uint32_t face_size, std::uint32_t* blocks, std::uint32_t block_size, NodePool* pool);

    /// Takes up to `steps` steps; false when none is left. A step visits a block, in step 1 with a
    /// classification of each face in the parent's list and in step 3, once a component, with a crossing test
    /// of each face; or, in step 2, a pair of neighbours, with a crossing test of each face in the plane
    /// between them.
    bool step(std::uint32_t steps);

    std::uint64_t blocks_visited() const { return visited_; } ///< in step 1
    std::uint64_t pairs_visited() const { return pairs_; }    ///< in step 2
    const StageCounts& stages() const { return stages_; }     ///< in step 1

    /// The tree. Called before step has returned false it gives the labelling up. Status: ok;
    /// scratch_too_small when there were too few words for blocks (blocks_needed says how many suffice);
    /// pool_exhausted; unfinished. When not ok the pool is as it was at begin.
    LabellingOutcome finish();

  private:
    /// In the order of work, behind those that have none left.
    enum class Phase : std::uint8_t { done, given_up, marking, linking, folding };
    struct Frame {
        std::uint32_t faces; ///< length of the prefix of the face list that meets this block
        std::uint32_t index; ///< of its word
    };
    struct Link {
        std::uint32_t low;  ///< the word of the block below the plane
        std::uint32_t high; ///< of the block above
        Block block;        ///< the smaller of the two, or the one of its size below the plane
    };
    void mark();
    void leave();
    bool fits() const { return needed_ <= block_size_; }
    void append(std::uint32_t word);
    void start_linking();
    void link();
    std::int32_t change_across(const Block& below) const;
    void fold();
    void set_leaf(Colour colour);
    Colour colour_of_leaf();
    bool is_component_inside() const;

    CheckedSolid solid_ = CheckedSolid::vouched(Solid{});
    WindingRule winding_ = WindingRule::nonzero;
    Phase phase_ = Phase::done;
    int depth_ = 0;
    std::uint32_t* list_ = nullptr;
    std::uint32_t* blocks_ = nullptr;
    std::uint32_t block_size_ = 0;
    std::uint32_t count_ = 0;  ///< blocks that stand
    std::uint32_t needed_ = 0; ///< the most that stood at once
    std::uint32_t components_ = 0;
    std::uint32_t walls_ = 0; ///< length of the prefix of faces in the plane between the halves
    std::uint32_t at_ = 0;    ///< the word being folded
    int links_ = 0;
    bool met_ = false;            ///< the block just left is one boundary leaf
    std::uint64_t first_met_ = 0; ///< and, a bit a level, the first half of that level was
    std::uint64_t visited_ = 0;
    std::uint64_t pairs_ = 0;
    StageCounts stages_ = {};
    Block block_ = {root_octant.corner, 0};
    Frame frames_[max_block_level] = {};
    Link link_[2 * max_depth + 1] = {};
    TreeBuilder builder_;
};

/// Converts in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
LabellingOutcome convert_by_labelling(Labelling& job, const CheckedSolid& solid, int depth,
                                      WindingRule winding, std::uint32_t* faces, std::uint32_t face_size,
                                      std::uint32_t* blocks, std::uint32_t block_size, NodePool* pool);

} // namespace osem

#endif
