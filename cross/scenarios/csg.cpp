// Scenarios of expressions over a solid, a tree and a stream.
#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

constexpr Operator operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                  Operator::exclusive_or};
constexpr CsgToken solid = CsgToken::of(0U);
constexpr CsgToken tree = CsgToken::of(1U);
constexpr CsgToken stream = CsgToken::of(2U);
constexpr CsgToken inverted = CsgToken::complement();
constexpr CsgToken unite = CsgToken::of(Operator::unite);
constexpr CsgToken intersect = CsgToken::of(Operator::intersect);
constexpr CsgToken subtract = CsgToken::of(Operator::subtract);

CheckedSolid checked(const Solid& unchecked) { return check(unchecked, edges, most_corners).solid; }

ConvertOptions options_of(int depth, LeafRule leaves) {
    ConvertOptions options;
    options.depth = depth;
    options.leaves = leaves;
    return options;
}

// An octahedron, and before it a tree and a stream made of other solids: one solid at a time is there.
class Work {
  public:
    explicit Work(LeafRule leaves)
        : leaves_(leaves), stream_(memory_source(bytes_, written())),
          tree_(converted(tetrahedra(205, Point{{0, 0, 0}}, root_side), options_of(4, leaves)).tree),
          solid_(checked(octahedron()), WindingRule::nonzero, faces_, sizeof faces_ / sizeof *faces_) {}

    std::uint8_t& byte(std::size_t at) { return bytes_[at]; }
    std::size_t size() const { return size_; }

    // The tree is given back at once. Not inlined: the callers' stack would hold the outcomes of all calls.
    template <std::uint32_t count>
    [[gnu::noinline]] void add(Digest& digest, const CsgToken (&tokens)[count],
                               std::uint32_t budget = UINT32_MAX) {
        const std::uint32_t mark = pool.used();
        const CsgOperand operands[] = {solid_, tree_, stream_};
        CsgOptions options;
        options.depth = 4;
        options.leaves = leaves_;
        add(digest, job_.begin(tokens, count, operands, 3, options, &pool));
        while (job_.step(budget)) digest.add(job_.decided_volume());
        const CsgOutcome outcome = job_.finish();
        add(digest, outcome.fault);
        digest.add(outcome.built.nodes_needed);
        digest.add(job_.octants_visited());
        if (outcome.built.status == Status::ok) digest.add(osem::digest(outcome.built.tree));
        pool.roll_back(mark);
    }

  private:
    static void add(Digest& digest, const CsgFault& fault) {
        digest.add(fault.status);
        digest.add(fault.token);
        digest.add(fault.operand);
        digest.add(fault.offset);
    }

    static bool take(void* work, const std::uint8_t* from, std::size_t count) {
        Work& to = *static_cast<Work*>(work);
        if (count > sizeof to.bytes_ - to.size_) return false;
        for (std::size_t i = 0; i < count; ++i) to.bytes_[to.size_++] = from[i];
        return true;
    }

    std::size_t written() {
        const Octree of_plate = converted(plate(), options_of(3, leaves_)).tree;
        write_stream(of_plate, StreamHeader{}, Sink{take, this});
        return size_;
    }

    std::size_t size_ = 0;
    std::uint8_t bytes_[stream_size(1 + 8 + 64)] = {};
    std::uint32_t faces_[8] = {};
    LeafRule leaves_;
    CsgConversion job_;
    CsgStream stream_;
    CsgTree tree_;
    CsgSolid solid_;
};

std::uint64_t expressions(LeafRule leaves) {
    Digest digest;
    Work& work = fresh<Work>(leaves);
    for (const Operator first : operators) {
        for (const Operator second : operators) {
            work.add(digest, {solid, tree, CsgToken::of(first), stream, CsgToken::of(second)});
            work.add(digest, {stream, solid, tree, CsgToken::of(first), inverted, CsgToken::of(second)});
        }
    }
    work.add(digest, {solid, tree, unite, solid, stream, intersect, subtract}, 7);
    work.add(digest, {solid, tree, subtract, tree, intersect});
    work.add(digest, {stream, solid, solid, subtract, unite}, 1);
    work.add(digest, {solid, unite});
    return digest.value();
}

} // namespace

std::uint64_t expressions_conservative() { return expressions(LeafRule::conservative); }

std::uint64_t expressions_centre() { return expressions(LeafRule::centre); }

// Every byte of a stream changed while it is an operand.
std::uint64_t expressions_of_damaged_streams() {
    Digest digest;
    Work& work = fresh<Work>(LeafRule::conservative);
    for (std::size_t at = 0; at < work.size(); ++at) {
        const std::uint8_t right = work.byte(at);
        work.byte(at) = static_cast<std::uint8_t>(right ^ (1U << (at % 8)));
        work.add(digest, {solid, stream, subtract});
        work.byte(at) = right;
    }
    return digest.value();
}

// Random tokens, most of them no expression, and their values for random colours.
std::uint64_t evaluated_expressions() {
    Digest digest;
    Random random(31);
    CsgToken tokens[9];
    for (int round = 0; round < 3000; ++round) {
        std::uint32_t count = 0;
        const std::uint32_t most = 1 + static_cast<std::uint32_t>(random.below(9));
        for (std::int32_t values = 0; count < most; ++count) {
            const bool push = values < 2 || random.below(2) == 0;
            tokens[count] = push ? CsgToken::of(static_cast<unsigned>(random.below(4)))
                                 : CsgToken::of(operators[random.below(4)]);
            values += push ? 1 : -1;
            if (push && random.below(6) == 0) tokens[count] = inverted;
        }
        CsgExpression expression;
        std::uint32_t where = 0;
        const Status status = expression.begin(tokens, count, 4, where);
        digest.add(status);
        digest.add(where);
        if (status != Status::ok) continue;
        const auto may = static_cast<std::uint16_t>(random.below(16));
        const auto must = static_cast<std::uint16_t>(random.below(16));
        const CsgTerm term = expression.evaluate(CsgColours{may, must});
        digest.add(term.colour());
        digest.add(std::uint32_t{term.matters});
    }
    return digest.value();
}

} // namespace osem::cross
