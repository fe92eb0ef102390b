#include "osem/csg.hpp"

#include "csg/walker.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

constexpr std::uint16_t all_operands = 0xffff;

std::uint16_t bit_of(std::uint32_t operand) { return static_cast<std::uint16_t>(1U << operand); }

void set_colour(CsgColours& colours, std::uint32_t operand, Colour colour) {
    const unsigned bits = static_cast<unsigned>(colour);
    const unsigned others = ~(1U << operand);
    colours.may = static_cast<std::uint16_t>((colours.may & others) | ((bits & 1U) << operand));
    colours.must = static_cast<std::uint16_t>((colours.must & others) | ((bits >> 1) << operand));
}

// The operands at one octant of the walk.
class Visit {
  public:
    Visit(const CsgOperand* operands, std::uint32_t count, const CsgOptions& options, const Octant& octant,
          const Octant& parent, unsigned child)
        : operands_(operands), count_(count), options_(options), octant_(octant), parent_(parent),
          child_(child) {}

    // Trees and streams are looked at first, then solids as long as the expression depends on them. A solid
    // that is not looked at stays grey.
    CsgTerm look(const CsgExpression& expression, CsgColours& colours) const {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (!CsgWalker(operands_[i]).is_solid()) look_at(i, colours);
        }
        CsgTerm term = expression.evaluate(colours);
        for (std::uint32_t i = 0; i < count_; ++i) {
            if ((term.matters & bit_of(i)) == 0 || !CsgWalker(operands_[i]).is_solid()) continue;
            if (look_at(i, colours)) term = expression.evaluate(colours);
        }
        return term;
    }

    // Enters the octant with the grey operands in `entered`, and goes past it with the others, which are
    // white from here on: nothing depends on them any more.
    void part(std::uint16_t entered, CsgColours& colours) const {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if ((colours.grey() & bit_of(i)) == 0) continue;
            if ((entered & bit_of(i)) != 0) {
                CsgWalker(operands_[i]).enter(octant_, parent_, child_);
            } else {
                CsgWalker(operands_[i]).leave_out();
                set_colour(colours, i, Colour::white);
            }
        }
    }

  private:
    // Whether the operand has got a leaf's colour.
    bool look_at(std::uint32_t i, CsgColours& colours) const {
        if ((colours.grey() & bit_of(i)) == 0) return false;
        const Colour colour = CsgWalker(operands_[i]).look_at(octant_, options_, parent_, child_);
        set_colour(colours, i, colour);
        return colour != Colour::grey;
    }

    const CsgOperand* operands_;
    std::uint32_t count_;
    const CsgOptions& options_;
    const Octant& octant_;
    const Octant& parent_;
    unsigned child_;
};

} // namespace

CsgFault CsgConversion::begin(const CsgToken* tokens, std::uint32_t token_count, const CsgOperand* operands,
                              std::uint32_t operand_count, const CsgOptions& options, NodePool* pool) {
    builder_.abandon();
    level_ = -1;
    fault_ = CsgFault{Status::ok, 0, 0, 0};
    CsgFault fault = fault_;
    fault.status = expression_.begin(tokens, token_count, operand_count, fault.token);
    if (fault.status != Status::ok) return fault;
    fault.token = 0;
    if (options.depth < 1 || options.depth > greatest_depth(options.leaves)) {
        return {Status::depth_out_of_range, 0, operand_count, 0};
    }
    for (std::uint32_t i = 0; i < operand_count; ++i) {
        const CsgWalker walker(operands[i]);
        Status status = Status::ok;
        for (std::uint32_t j = 0; j < i && status == Status::ok; ++j) {
            if (walker.is_same_as(operands[j])) status = Status::operand_repeated;
        }
        if (status == Status::ok) status = walker.begin(options);
        if (status == Status::ok) continue;
        fault = {status, 0, i, 0};
        static_cast<void>(walker.status(fault.offset));
        return fault;
    }
    operands_ = operands;
    operand_count_ = operand_count;
    options_ = options;
    visited_ = 0;
    octant_ = root_octant;
    builder_.begin(pool);
    return fault;
}

bool CsgConversion::step(std::uint32_t octants) {
    for (; octants > 0 && builder_.building(); --octants) {
        const unsigned child = level_ < 0 ? 0 : frames_[level_].child;
        visit(level_ < 0 ? root_octant : octant_.child(child), child);
        ++visited_;
    }
    return builder_.building();
}

void CsgConversion::visit(const Octant& octant, unsigned child) {
    CsgColours colours = level_ < 0 ? CsgColours{0, all_operands} : frames_[level_].colours;
    const Visit visit(operands_, operand_count_, options_, octant, octant_, child);
    const CsgTerm term = visit.look(expression_, colours);
    const auto entered = static_cast<std::uint16_t>(term.matters & colours.grey());
    visit.part(entered, colours);
    if (entered != 0) {
        enter(octant, child, colours);
    } else {
        set_leaf(term.colour(), child);
    }
    for (std::uint32_t i = 0; i < operand_count_ && fault_.status == Status::ok; ++i) {
        fault_.operand = i;
        fault_.status = CsgWalker(operands_[i]).status(fault_.offset);
    }
    if (fault_.status != Status::ok) builder_.abandon();
}

void CsgConversion::set_leaf(Colour colour, unsigned child) {
    if (level_ >= 0) {
        builder_.leaf(child, colour);
        leave();
        return;
    }
    const Node node = Node::uniform(colour);
    builder_.leaves(node.may, node.must);
    builder_.close();
}

void CsgConversion::enter(const Octant& octant, unsigned child, const CsgColours& colours) {
    if (level_ >= 0) builder_.open(child);
    octant_ = octant;
    frames_[++level_] = Frame{colours, 0};
}

// Goes on to the next child, and closes every octant whose last child is done.
void CsgConversion::leave() {
    while (++frames_[level_].child == 8) {
        builder_.close();
        if (--level_ < 0) return;
        octant_ = octant_.parent();
    }
}

std::uint64_t CsgConversion::decided_volume() const {
    if (builder_.finished()) return root_volume;
    std::uint64_t decided = 0;
    for (int level = 0; level <= level_; ++level) decided += frames_[level].child * volume_at(level + 1);
    return decided;
}

CsgOutcome CsgConversion::finish() {
    CsgOutcome outcome = {builder_.finish(options_.depth), fault_};
    if (fault_.status != Status::ok) outcome.built.status = fault_.status;
    outcome.fault.status = outcome.built.status;
    return outcome;
}

CsgOutcome convert_expression(CsgConversion& job, const CsgToken* tokens, std::uint32_t token_count,
                              const CsgOperand* operands, std::uint32_t operand_count,
                              const CsgOptions& options, NodePool* pool) {
    const CsgFault fault = job.begin(tokens, token_count, operands, operand_count, options, pool);
    if (fault.status != Status::ok) {
        return {{fault.status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}}, fault};
    }
    run_to_end(job);
    return job.finish();
}

} // namespace osem
