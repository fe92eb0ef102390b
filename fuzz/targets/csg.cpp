// Expressions over trees, streams and solids converted in one walk, against what they mean cell by cell:
// every operand converted by itself and every value that it can have tried.
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "osem/convert.hpp"
#include "osem/csg.hpp"
#include "osem/stream.hpp"
#include "support/any_grid.hpp"
#include "support/any_solid.hpp"
#include "support/byte_stream.hpp"
#include "support/expressions.hpp"
#include "support/forest.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

using tests::Tokens;

CsgToken any_token(std::uint32_t operands, Choices& choices) {
    const std::uint8_t kind = choices.byte();
    if (kind < 128) return CsgToken::of(kind % (operands + 1)); // one of them does not exist
    if (kind < 208) return CsgToken::of(static_cast<Operator>(kind % 4));
    if (kind < 248) return CsgToken::complement();
    CsgToken token = CsgToken::of(static_cast<Operator>(choices.byte()));
    token.kind = static_cast<CsgTokenKind>(choices.byte());
    return token;
}

/// Tokens in an order that has a meaning: an operand where there are too few values, operators at the end.
Tokens sound_tokens(std::uint32_t operands, Choices& choices) {
    Tokens tokens;
    unsigned values = 0;
    const unsigned wanted = 1 + choices.below(12);
    for (unsigned places = 0; places < wanted || values > 1;) {
        const std::uint8_t kind = choices.byte();
        if (values > 1 && (kind < 100 || places == wanted)) {
            tokens.push_back(CsgToken::of(static_cast<Operator>(kind % 4)));
            --values;
        } else if (values > 0 && kind > 220) {
            tokens.push_back(CsgToken::complement());
        } else if (places < wanted) {
            tokens.push_back(CsgToken::of(kind % operands));
            ++values;
            ++places;
        }
        if (tokens.size() > 60) break;
    }
    return tokens;
}

struct Validity {
    bool is_valid;
    bool is_too_large;
};

/// Whether a token finds the values that it takes; it leaves one.
bool takes(const CsgToken& token, std::uint32_t operands, unsigned& values) {
    switch (token.kind) {
    case CsgTokenKind::operand:
        ++values;
        return token.operand < operands;
    case CsgTokenKind::combine:
        if (values < 2 || static_cast<unsigned>(token.op) > 3) return false;
        --values;
        return true;
    case CsgTokenKind::complement:
        return values > 0;
    }
    return false;
}

/// What is too large is so by the tokens before the first that is not valid.
Validity validity(const Tokens& tokens, std::uint32_t operands) {
    Validity found = {true, tokens.size() > csg_most_tokens || operands > csg_most_operands};
    std::vector<unsigned> uses(operands);
    unsigned values = 0;
    for (const CsgToken& token : tokens) {
        found.is_valid = takes(token, operands, values);
        if (!found.is_valid) break;
        if (token.kind == CsgTokenKind::operand) ++uses[token.operand];
    }
    found.is_valid = found.is_valid && values == 1;
    const auto repeated = std::count_if(uses.begin(), uses.end(), [](unsigned n) { return n > 1; });
    found.is_too_large = found.is_too_large || repeated > csg_most_repeated;
    return found;
}

bool depends(const Tokens& tokens, std::vector<Colour> colours, std::size_t operand) {
    for (Colour& colour : colours) colour = colour == Colour::grey ? Colour::boundary : colour;
    colours[operand] = Colour::grey;
    return tests::depends_on_grey(tokens, colours);
}

/// The expression's value in octants of any colours.
void test_evaluation(const CsgExpression& expression, const Tokens& tokens, std::uint32_t operands,
                     Choices& choices) {
    std::vector<Colour> colours;
    CsgColours masks = {0, 0};
    for (std::uint32_t i = 0; i < operands; ++i) {
        const std::uint32_t colour = choices.below(4);
        colours.push_back(static_cast<Colour>(colour));
        masks.may = static_cast<std::uint16_t>(masks.may | (colour & 1U) << i);
        masks.must = static_cast<std::uint16_t>(masks.must | (colour >> 1) << i);
    }
    const CsgTerm term = expression.evaluate(masks);
    EXPECT_EQ(term.colour(), tests::colour_at(tokens, colours));
    if (term.is_known()) {
        EXPECT_EQ(term.matters, 0U);
        return;
    }
    for (std::uint32_t i = 0; i < operands; ++i) {
        const auto uses = std::count_if(tokens.begin(), tokens.end(), [&](const CsgToken& token) {
            return token.kind == CsgTokenKind::operand && token.operand == i;
        });
        const bool unknown = colours[i] == Colour::boundary || colours[i] == Colour::grey;
        const bool matters = unknown && (uses > 1 || (uses == 1 && depends(tokens, colours, i)));
        EXPECT_EQ(((term.matters >> i) & 1U) != 0, matters);
    }
}

/// An operand in one of its three forms, and its colours cell by cell.
struct Operand {
    enum class Form { tree, stream, solid };
    Operand(Form f, const tests::DenseGrid& cells) : form(f), grid(cells) {}

    Form form;
    tests::DenseGrid grid;
    std::size_t in_forest = 0;
    tests::Bytes bytes;
    std::unique_ptr<tests::SmallSolid> solid;
    WindingRule winding = WindingRule::nonzero;
    std::vector<std::uint32_t> faces;
};

Operand solid_operand(int depth, LeafRule leaves, Choices& choices) {
    Operand operand(Operand::Form::solid, tests::DenseGrid(depth));
    operand.solid = std::make_unique<tests::SmallSolid>(any_solid(root_octant, choices));
    operand.winding = static_cast<WindingRule>(choices.below(3));
    operand.faces.resize(operand.solid->face_count());
    tests::HeapPool pool(5000);
    const TreeOutcome alone = tests::converted(*operand.solid, {depth, leaves, operand.winding}, &*pool);
    EXPECT_EQ(alone.status, Status::ok);
    operand.grid = tests::expand(alone.tree, depth);
    return operand;
}

Operand any_operand(Forest& forest, int depth, LeafRule leaves, Choices& choices) {
    const std::uint32_t form = choices.below(4);
    if (form == 3) return solid_operand(depth, leaves, choices);
    const tests::DenseGrid own =
        any_grid(1 + static_cast<int>(choices.below(static_cast<std::uint32_t>(depth))), choices);
    Operand operand(form == 2 ? Operand::Form::stream : Operand::Form::tree, tests::refined(own, depth));
    const TreeOutcome planted = forest.build([&](NodePool& pool) { return tests::plant(own, &pool); });
    operand.in_forest = forest.size();
    forest.add(planted.tree, own);
    operand.bytes = tests::written(planted.tree, StreamHeader{});
    return operand;
}

/// The kernel's operand objects of one walk.
class Operands {
  public:
    Operands(std::vector<Operand>& operands, const Forest& forest) {
        for (Operand& operand : operands) {
            switch (operand.form) {
            case Operand::Form::tree:
                trees_.push_back(std::make_unique<CsgTree>(forest[operand.in_forest].tree));
                all_.emplace_back(*trees_.back());
                break;
            case Operand::Form::stream:
                streams_.push_back(
                    std::make_unique<CsgStream>(memory_source(operand.bytes.data(), operand.bytes.size())));
                all_.emplace_back(*streams_.back());
                break;
            case Operand::Form::solid:
                solids_.push_back(std::make_unique<CsgSolid>(
                    operand.solid->vouched(), operand.winding, operand.faces.data(),
                    static_cast<std::uint32_t>(operand.faces.size())));
                all_.emplace_back(*solids_.back());
                break;
            }
        }
    }
    const CsgOperand* data() const { return all_.data(); }

  private:
    std::vector<std::unique_ptr<CsgTree>> trees_;
    std::vector<std::unique_ptr<CsgStream>> streams_;
    std::vector<std::unique_ptr<CsgSolid>> solids_;
    std::vector<CsgOperand> all_;
};

/// One byte of one stream changed: the walk refuses it, or does not care, but always sees it.
void test_damaged(std::vector<Operand>& operands, const Tokens& tokens, const CsgOptions& options,
                  Forest& forest, Choices& choices) {
    const std::uint32_t hit = choices.below(static_cast<std::uint32_t>(operands.size()));
    if (operands[hit].form != Operand::Form::stream) return;
    std::uint8_t& byte =
        operands[hit].bytes[choices.below(static_cast<std::uint32_t>(operands[hit].bytes.size()))];
    byte = static_cast<std::uint8_t>(byte ^ (1U + choices.below(255)));
    const Operands objects(operands, forest);
    const tests::PoolImage before(forest.pool());
    CsgConversion job;
    const CsgOutcome outcome =
        convert_expression(job, tokens.data(), static_cast<std::uint32_t>(tokens.size()), objects.data(),
                           static_cast<std::uint32_t>(operands.size()), options, &*forest.pool());
    EXPECT_NE(outcome.fault.status, Status::ok);
    if (outcome.fault.status != Status::pool_exhausted) {
        EXPECT_EQ(outcome.fault.operand, hit);
    }
    EXPECT_TRUE(before.same_nodes(forest.pool()));
}

void test_walk(const Tokens& tokens, std::uint32_t count, Choices& choices) {
    CsgOptions options;
    options.depth = 1 + static_cast<int>(choices.below(3));
    options.leaves = choices.flag() ? LeafRule::centre : LeafRule::conservative;
    Forest forest(any_room(choices));
    std::vector<Operand> operands;
    for (std::uint32_t i = 0; i < count; ++i) {
        operands.push_back(any_operand(forest, options.depth, options.leaves, choices));
    }
    CsgConversion job;
    const bool given_up = choices.below(8) == 0;
    const auto token_count = static_cast<std::uint32_t>(tokens.size());
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        const Operands objects(operands, forest);
        if (given_up) {
            EXPECT_EQ(job.begin(tokens.data(), token_count, objects.data(), count, options, &pool).status,
                      Status::ok);
            job.step(choices.byte());
        }
        const CsgFault fault = job.begin(tokens.data(), token_count, objects.data(), count, options, &pool);
        EXPECT_EQ(fault.status, Status::ok) << describe(fault.status);
        step_through(job, choices);
        return job.finish().built;
    });
    tests::DenseGrid expected(options.depth);
    std::vector<Colour> colours(count);
    for (std::size_t cell = 0; cell < expected.size(); ++cell) {
        for (std::uint32_t i = 0; i < count; ++i) colours[i] = operands[i].grid[cell];
        expected[cell] = tests::colour_at(tokens, colours);
    }
    forest.add(outcome.tree, expected);
    test_damaged(operands, tokens, options, forest, choices);
}

} // namespace

void run(Choices& choices) {
    const bool sound = choices.below(4) != 0;
    const std::uint32_t operands = 1 + choices.below(sound ? 4 : 18);
    Tokens tokens;
    if (sound) {
        tokens = sound_tokens(operands, choices);
    } else {
        for (std::uint32_t n = choices.below(70); n > 0; --n) tokens.push_back(any_token(operands, choices));
    }
    osem::CsgExpression expression;
    std::uint32_t where = 0;
    const auto token_count = static_cast<std::uint32_t>(tokens.size());
    const osem::Status status = expression.begin(tokens.data(), token_count, operands, where);
    const Validity expected = validity(tokens, operands);
    EXPECT_EQ(status == osem::Status::ok, expected.is_valid && !expected.is_too_large);
    if (status == osem::Status::expression_invalid) {
        EXPECT_FALSE(expected.is_valid);
    }
    if (status == osem::Status::expression_too_large) {
        EXPECT_TRUE(expected.is_too_large);
    }
    if (status != osem::Status::ok) {
        EXPECT_LE(where, token_count);
        return;
    }
    test_evaluation(expression, tokens, operands, choices);
    if (operands <= 4) test_walk(tokens, operands, choices);
}

} // namespace osem::fuzz
