#include "support/expressions.hpp"

namespace osem::tests {

const std::vector<Operator> operators = {Operator::unite, Operator::intersect, Operator::subtract,
                                         Operator::exclusive_or};

namespace {

// Of `leaves` operands chosen by `next_operand`.
template <class NextOperand>
void append_expression(Tokens& tokens, unsigned leaves, std::mt19937& random,
                       const NextOperand& next_operand) {
    if (leaves == 1) {
        tokens.push_back(CsgToken::of(next_operand()));
    } else {
        const unsigned left = 1 + static_cast<unsigned>(random() % (leaves - 1));
        append_expression(tokens, left, random, next_operand);
        append_expression(tokens, leaves - left, random, next_operand);
        tokens.push_back(CsgToken::of(operators[random() % 4]));
    }
    if (random() % 4 == 0) tokens.push_back(CsgToken::complement());
}

bool value_of(const Tokens& tokens, unsigned inside) {
    std::vector<bool> values;
    for (const CsgToken& token : tokens) {
        if (token.kind == CsgTokenKind::operand) {
            values.push_back(((inside >> token.operand) & 1U) != 0);
            continue;
        }
        const bool b = values.back();
        if (token.kind == CsgTokenKind::complement) {
            values.back() = !b;
            continue;
        }
        values.pop_back();
        const bool a = values.back();
        switch (token.op) {
        case Operator::unite:
            values.back() = a || b;
            break;
        case Operator::intersect:
            values.back() = a && b;
            break;
        case Operator::subtract:
            values.back() = a && !b;
            break;
        case Operator::exclusive_or:
            values.back() = a != b;
            break;
        }
    }
    return values.back();
}

// The bits that the operands can be at a point of an octant in which they have these colours (grey: either).
std::vector<unsigned> possible(const std::vector<Colour>& colours) {
    std::vector<unsigned> all = {0};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const std::size_t count = all.size();
        const bool either = colours[i] == Colour::boundary || colours[i] == Colour::grey;
        for (std::size_t j = 0; j < count; ++j) {
            const unsigned inside = all[j] | (1U << i);
            if (either) all.push_back(inside);
            if (colours[i] == Colour::black) all[j] = inside;
        }
    }
    return all;
}

} // namespace

Tokens any_expression(unsigned leaves, unsigned operand_count, std::mt19937& random) {
    Tokens tokens;
    append_expression(tokens, leaves, random,
                      [&] { return static_cast<unsigned>(random() % operand_count); });
    return tokens;
}

Tokens read_once_expression(unsigned operand_count, std::mt19937& random) {
    Tokens tokens;
    unsigned next = 0;
    append_expression(tokens, operand_count, random, [&] { return next++; });
    return tokens;
}

Colour colour_at(const Tokens& tokens, const std::vector<Colour>& colours) {
    bool may = false;
    bool must = true;
    for (const unsigned inside : possible(colours)) {
        const bool value = value_of(tokens, inside);
        may = may || value;
        must = must && value;
    }
    return must ? Colour::black : may ? Colour::boundary : Colour::white;
}

// Whether the value depends on an operand that is divided.
bool depends_on_grey(const Tokens& tokens, const std::vector<Colour>& colours) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (colours[i] != Colour::grey) continue;
        for (const unsigned inside : possible(colours)) {
            if (value_of(tokens, inside) != value_of(tokens, inside ^ (1U << i))) return true;
        }
    }
    return false;
}

} // namespace osem::tests
