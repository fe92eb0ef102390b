#include "osem/csg.hpp"

namespace osem {

namespace {

// Values on the stack of an evaluation: each but the last takes an operand and a combination.
constexpr std::uint32_t most_values = (csg_most_tokens + 1) / 2;

CsgTerm complement_of(const CsgTerm& a) { return {!a.must, !a.may, a.matters}; }

// Kleene's connectives on (may, must). What is known depends on nothing.
CsgTerm combined(Operator op, const CsgTerm& a, const CsgTerm& b) {
    CsgTerm term = {a.may && b.may, a.must && b.must, 0};
    if (op == Operator::unite) {
        term = {a.may || b.may, a.must || b.must, 0};
    } else if (op == Operator::subtract) {
        term = {a.may && !b.must, a.must && !b.may, 0};
    } else if (op == Operator::exclusive_or) {
        term = {(a.may && !b.must) || (!a.must && b.may), (a.must && !b.may) || (!a.may && b.must), 0};
    }
    if (!term.is_known()) term.matters = static_cast<std::uint16_t>(a.matters | b.matters);
    return term;
}

// How many values a token takes from the stack; -1 when it is no token.
int values_taken(const CsgToken& token, std::uint32_t operand_count) {
    switch (token.kind) {
    case CsgTokenKind::operand:
        return token.operand < operand_count ? 0 : -1;
    case CsgTokenKind::combine:
        return token.op <= Operator::exclusive_or ? 2 : -1;
    case CsgTokenKind::complement:
        return 1;
    }
    return -1;
}

} // namespace

Status CsgExpression::begin(const CsgToken* tokens, std::uint32_t token_count, std::uint32_t operand_count,
                            std::uint32_t& where) {
    where = token_count < csg_most_tokens ? token_count : csg_most_tokens;
    if (token_count > csg_most_tokens || operand_count > csg_most_operands) {
        return Status::expression_too_large;
    }
    std::uint32_t values = 0;
    std::uint32_t repeated_count = 0;
    std::uint16_t once = 0;
    std::uint16_t repeated = 0;
    for (std::uint32_t i = 0; i < token_count; ++i) {
        where = i;
        const int taken = values_taken(tokens[i], operand_count);
        if (taken < 0 || values < static_cast<std::uint32_t>(taken)) return Status::expression_invalid;
        values -= static_cast<std::uint32_t>(taken);
        ++values;
        if (tokens[i].kind != CsgTokenKind::operand) continue;
        const auto bit = static_cast<std::uint16_t>(1U << tokens[i].operand);
        if ((once & bit) != 0 && (repeated & bit) == 0) {
            repeated = static_cast<std::uint16_t>(repeated | bit);
            if (++repeated_count > csg_most_repeated) return Status::expression_too_large;
        }
        once = static_cast<std::uint16_t>(once | bit);
    }
    where = token_count;
    if (values != 1) return Status::expression_invalid;
    tokens_ = tokens;
    token_count_ = token_count;
    repeated_ = repeated;
    return Status::ok;
}

CsgTerm CsgExpression::evaluate_once(const CsgColours& colours) const {
    CsgTerm stack[most_values];
    CsgTerm* top = stack; // behind the topmost value
    for (std::uint32_t i = 0; i < token_count_; ++i) {
        const CsgToken& token = tokens_[i];
        if (token.kind == CsgTokenKind::operand) {
            const auto bit = static_cast<std::uint16_t>(1U << token.operand);
            const bool unknown = (colours.unknown() & bit) != 0;
            const bool may = unknown || (colours.may & bit) != 0;
            *top++ = {may, may && !unknown, unknown ? bit : std::uint16_t{0}};
        } else if (token.kind == CsgTokenKind::complement) {
            top[-1] = complement_of(top[-1]);
        } else {
            --top;
            top[-1] = combined(token.op, top[-1], *top);
        }
    }
    return stack[0];
}

// The repeated operands that are unknown are counted through as the bits of a number.
CsgTerm CsgExpression::evaluate(const CsgColours& colours) const {
    const auto tried = static_cast<std::uint16_t>(repeated_ & colours.unknown());
    CsgTerm all = {false, true, tried};
    unsigned inside = 0;
    do {
        const auto may = static_cast<std::uint16_t>((colours.may & ~tried) | inside);
        const auto must = static_cast<std::uint16_t>((colours.must & ~tried) | inside);
        const CsgTerm term = evaluate_once(CsgColours{may, must});
        all.may = all.may || term.may;
        all.must = all.must && term.must;
        all.matters = static_cast<std::uint16_t>(all.matters | term.matters);
        inside = (inside - tried) & tried;
    } while (inside != 0);
    if (all.is_known()) all.matters = 0;
    return all;
}

} // namespace osem
