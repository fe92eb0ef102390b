// An operand on its way down the octants, whichever kind it is.
#ifndef OSEM_CSG_WALKER_HPP
#define OSEM_CSG_WALKER_HPP

#include "osem/csg.hpp"

namespace osem {

/// The calls come in the order of a walk in preorder: begin; then for every child of an entered octant in
/// which the operand is grey look_at, and after that, where it answered grey, enter or leave_out.
class CsgWalker {
  public:
    explicit CsgWalker(const CsgOperand& operand) : operand_(operand) {}

    /// Status: ok; depth_out_of_range; scratch_too_small; what StreamCursor::begin answers.
    Status begin(const CsgOptions& options) const;

    /// Whether two operands are the same object, whose state one walk needs for itself.
    bool is_same_as(const CsgOperand& other) const {
        return operand_.solid_ == other.solid_ && operand_.tree_ == other.tree_ &&
               operand_.stream_ == other.stream_;
    }

    bool is_solid() const { return operand_.solid_ != nullptr; }

    /// The colour in an octant, child `child` of the entered octant `parent`; the root is a child of none.
    Colour look_at(const Octant& octant, const CsgOptions& options, const Octant& parent,
                   unsigned child) const;

    /// The octant looked at is entered, or it is not.
    void enter(const Octant& octant, const Octant& parent, unsigned child) const;
    void leave_out() const;

    /// Status: ok; the fault of a stream. `offset` is that of the byte at which it was seen.
    Status status(std::uint64_t& offset) const;

  private:
    const CsgOperand& operand_;
};

} // namespace osem

#endif
