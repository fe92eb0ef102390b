// The path of open octants while the codes of a stream go by: what stands where, and whether it may.
#ifndef OSEM_PREORDER_PATH_HPP
#define OSEM_PREORDER_PATH_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/node_pool.hpp"
#include "osem/status.hpp"

namespace osem {

/// Whether the codes of eight children, two bits each, are those of leaves of one colour.
constexpr bool is_one_leaf(std::uint16_t codes) {
    return codes == 0x0000U || codes == 0x5555U || codes == 0xffffU;
}

/// Follows a depth-first expression code by code with O(depth) state, and refuses what no writer gives.
/// After a fault only begin may follow.
class PreorderPath {
  public:
    /// Starts before the root octant of an expression of `nodes` grey octants, leaves no deeper than `depth`.
    void begin(int depth, std::uint32_t nodes);

    /// Takes the code of the next octant. Precondition: not whole(). Status: ok; stream_too_deep;
    /// stream_count_mismatch; stream_not_canonical.
    Status take(Colour code);

    /// Takes the codes of all eight children of the octant just entered. Precondition: that code was grey,
    /// and theirs are of leaves of more than one colour. Status: ok; stream_count_mismatch.
    Status take_leaves();

    /// Whether the root octant is complete.
    bool whole() const { return level_ == 0 && left_[0] == 0; }
    /// Level of the next octant, and which child of its parent it is; 0 and 0 for the root, and when whole.
    int level() const { return level_; }
    unsigned child() const { return level_ == 0 ? 0 : 8U - left_[level_]; }

  private:
    friend class StreamCursor;
    friend class StreamCombination;

    Status take_buffered(const std::uint8_t* bytes, unsigned& at, unsigned limit, int floor,
                         std::uint32_t most);
    Status ascend();
    void leave();
    int level_above() const;
    bool may_open() const { return level_ < depth_ && nodes_left_ != 0; }
    bool may_end() const { return !alike_ && (nodes_left_ == 0 || level_above() != 0); }
    void enter(std::uint32_t children, bool alike);
    void look_ahead(std::uint32_t children, bool alike);
    void close();
    Octant taken(int level) const;
    std::uint64_t volume_before(int level) const;
    std::uint32_t to_come(int level) const;

    std::uint32_t nodes_left_ = 0;
    std::uint8_t depth_ = 0;
    std::uint8_t level_ = 0;
    Colour colour_ = Colour::white; ///< of the child that went by last
    bool alike_ = false;            ///< whether all children of the innermost open octant were such leaves
    std::uint8_t left_[max_depth + 1] = {}; ///< children to come of each open octant; the root's place first
};

} // namespace osem

#endif
