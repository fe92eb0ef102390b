// Expressions over solids, trees and streams, converted to one octree in one walk: nothing is materialised,
// and octants in which the expression is already decided are not entered ("lazy CSG").
#ifndef OSEM_CSG_HPP
#define OSEM_CSG_HPP

#include <cstdint>

#include "osem/boolean.hpp"
#include "osem/convert.hpp"
#include "osem/face_walk.hpp"
#include "osem/octree.hpp"
#include "osem/solid.hpp"
#include "osem/stream_cursor.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

constexpr std::uint32_t csg_most_operands = 16;
constexpr std::uint32_t csg_most_tokens = 64;
/// Operands that may stand more than once in an expression.
constexpr std::uint32_t csg_most_repeated = 6;

enum class CsgTokenKind : std::uint8_t { operand, combine, complement };

/// One token of an expression in postfix notation: an operand pushes its value, a combination pops b, then a,
/// and pushes `a op b`, a complement pops one value and pushes what the root holds outside of it.
/// (a - b) & !c is a b subtract c complement intersect.
struct CsgToken {
    CsgTokenKind kind;
    std::uint8_t operand; ///< of an operand: its place among the operands
    Operator op;          ///< of a combination

    static constexpr CsgToken of(unsigned operand) {
        return {CsgTokenKind::operand, static_cast<std::uint8_t>(operand), Operator::unite};
    }
    static constexpr CsgToken of(Operator op) { return {CsgTokenKind::combine, 0, op}; }
    static constexpr CsgToken complement() { return {CsgTokenKind::complement, 0, Operator::unite}; }
};

/// The colours of all operands in one octant, a bit an operand, as the masks of a node's children: grey
/// (0, 1) is an operand that is divided there, boundary (1, 0) one that may be either and is not divided.
struct CsgColours {
    std::uint16_t may;
    std::uint16_t must;

    constexpr std::uint16_t grey() const { return static_cast<std::uint16_t>(~may & must); }
    /// Operands that are neither white nor black.
    constexpr std::uint16_t unknown() const { return static_cast<std::uint16_t>(may ^ must); }
};

/// What an expression comes to in an octant: outside throughout (may false), inside throughout (must true),
/// or unknown (may only).
struct CsgTerm {
    bool may;
    bool must;
    /// When unknown: the unknown operands on which it depends, and all unknown ones that stand more than
    /// once; else 0.
    std::uint16_t matters;

    constexpr bool is_known() const { return may == must; }
    constexpr Colour colour() const { return must ? Colour::black : may ? Colour::boundary : Colour::white; }
};

/// A checked expression. At a point every operand is 0 or 1, in every place where it stands; so an octant is
/// decided exactly if the expression has one value whatever the unknown operands are. For operands that stand
/// once Kleene's three-valued logic finds that out: the parts of a connective then have no operand in
/// common. Operands that stand more than once are tried both ways, all that are unknown together. So
/// A - A is empty, A | !A is everything, and (A - B) & B is empty, boundary leaves and all.
class CsgExpression {
  public:
    /// Checks the tokens, which are only viewed. Status: ok; expression_invalid when there are too few values
    /// for a token, more than one value is left in the end, an operand is none of the `operand_count`, or a
    /// kind or an operator is no value of its enumeration; expression_too_large for more than csg_most_tokens
    /// tokens, csg_most_operands operands or csg_most_repeated repeated ones. `where` is the first token at
    /// fault, token_count when the end is. What is refused leaves the expression that was there before.
    Status begin(const CsgToken* tokens, std::uint32_t token_count, std::uint32_t operand_count,
                 std::uint32_t& where);

    /// The expression's value. Cost: tokens x 2^(repeated operands that are unknown).
    CsgTerm evaluate(const CsgColours& colours) const;

  private:
    CsgTerm evaluate_once(const CsgColours& colours) const;

    const CsgToken* tokens_ = nullptr;
    std::uint32_t token_count_ = 0;
    std::uint16_t repeated_ = 0;
};

struct CsgOptions {
    int depth = 8; ///< of the result: 1 to 20 (19 with centre leaves), no less than that of any operand
    LeafRule leaves = LeafRule::conservative; ///< of the solids' leaves at full depth
};

/// A solid as an operand: its face list and its state along the walk. It may be used again when the walk is
/// over, by one walk at a time.
class CsgSolid {
  public:
    /// Scratch: convert_scratch(solid.view()) indices, in use while the walk goes on.
    CsgSolid(const CheckedSolid& solid, WindingRule winding, std::uint32_t* scratch,
             std::uint32_t scratch_size)
        : solid_(solid), winding_(winding), list_(scratch), list_size_(scratch_size) {}

  private:
    friend class CsgWalker;
    Colour look_at(const Octant& octant, const CsgOptions& options, const Octant& parent, unsigned child);
    Colour leaf_colour(std::int32_t winding) const;
    void enter(const Octant& octant, const Octant& parent, unsigned child);

    CheckedSolid solid_;
    WindingRule winding_;
    std::uint32_t* list_;
    std::uint32_t list_size_;
    std::uint32_t met_ = 0; ///< faces that meet the octant looked at last
    FaceWalk faces_;
    FaceFrame frames_[max_depth] = {};
};

/// A tree of any pool as an operand.
class OSEM_OF_INDEX_WIDTH CsgTree {
  public:
    explicit CsgTree(const Octree& tree) : tree_(tree) {}

  private:
    friend class CsgWalker;
    Octree tree_;
    const Node* path_[max_depth] = {};
};

/// A stream as an operand, read where it lies, once from begin to end.
class CsgStream {
  public:
    explicit CsgStream(const Source& source) : source_(source) {}

  private:
    friend class CsgWalker;
    Source source_;
    StreamCursor cursor_;
};

/// One of the three.
class CsgOperand {
  public:
    CsgOperand(CsgSolid& solid) : solid_(&solid) {}     // NOLINT(google-explicit-constructor)
    CsgOperand(CsgTree& tree) : tree_(&tree) {}         // NOLINT(google-explicit-constructor)
    CsgOperand(CsgStream& stream) : stream_(&stream) {} // NOLINT(google-explicit-constructor)

  private:
    friend class CsgWalker;
    CsgSolid* solid_ = nullptr;
    CsgTree* tree_ = nullptr;
    CsgStream* stream_ = nullptr;
};

/// Why a walk did not begin, or did not end well.
struct CsgFault {
    Status status;
    std::uint32_t token;   ///< expression_invalid, expression_too_large: the token at fault
    std::uint32_t operand; ///< operand_repeated, depth_out_of_range, scratch_too_small, faults of a stream:
                           ///< the operand at fault; the operand count when the options are
    std::uint64_t offset;  ///< faults of a stream: the byte at which it was seen; else of no meaning
};

/// Outcome of a walk: the tree, and why there is none.
struct CsgOutcome {
    TreeOutcome built; ///< built.status is fault.status
    CsgFault fault;
};

/// An expression being converted: begin, step until done, finish. Memory beside the pool: this object, the
/// operands' objects, each O(depth), and the face lists of the solids, 4 bytes a face; all of it in the
/// caller's hands. Between begin and finish nothing else may append to the pool or use the operands.
///
/// Each octant visited is looked at by the operands that its parent left grey and on which the expression
/// still depends; trees and streams come first, as they are cheap. It becomes a leaf when the expression is
/// decided, and a boundary leaf when it depends on no operand that is divided there. (An unknown operand that
/// stands more than once counts as one on which it depends.)
class OSEM_OF_INDEX_WIDTH CsgConversion {
  public:
    /// Starts. Nodes go to `pool`, which may be a tree operand's own; with a null pool this is a counting
    /// pass. Tokens and operands are viewed until finish; no two operands may be the same object. An operand
    /// that stands in no token is not looked at but for its stream, which is read. Status: ok;
    /// expression_invalid; expression_too_large; depth_out_of_range; scratch_too_small; what
    /// StreamCursor::begin answers. When not ok, nothing has begun.
    CsgFault begin(const CsgToken* tokens, std::uint32_t token_count, const CsgOperand* operands,
                   std::uint32_t operand_count, const CsgOptions& options, NodePool* pool);

    /// Visits up to `octants` octants; false when none is left or a stream is at fault. Cost of a visit: for
    /// each solid looked at what Conversion::step says; O(1) for each tree; for each stream its codes up to
    /// the next octant visited; and an evaluation for each solid looked at, and one.
    bool step(std::uint32_t octants);

    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the root's volume (2^60 cells) is decided.
    std::uint64_t decided_volume() const;

    /// Octants visited so far, the root included.
    std::uint64_t octants_visited() const { return visited_; }

    /// The tree. Called before step has returned false it gives the walk up. Status: ok; pool_exhausted;
    /// unfinished if given up; a fault of a stream. When not ok the pool is as it was at begin.
    CsgOutcome finish();

  private:
    struct Frame {
        CsgColours colours; ///< of the operands in the open octant
        std::uint8_t child; ///< the child being visited
    };
    void visit(const Octant& octant, unsigned child);
    void set_leaf(Colour colour, unsigned child);
    void enter(const Octant& octant, unsigned child, const CsgColours& colours);
    void leave();

    CsgExpression expression_;
    const CsgOperand* operands_ = nullptr;
    std::uint32_t operand_count_ = 0;
    CsgOptions options_;
    CsgFault fault_ = {};
    std::uint64_t visited_ = 0;
    Octant octant_ = root_octant; ///< that of the frame on top
    int level_ = -1;              ///< of the frame on top
    Frame frames_[max_depth] = {};
    TreeBuilder builder_;
};

/// Converts in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
CsgOutcome convert_expression(CsgConversion& job, const CsgToken* tokens, std::uint32_t token_count,
                              const CsgOperand* operands, std::uint32_t operand_count,
                              const CsgOptions& options, NodePool* pool);

} // namespace osem

#endif
