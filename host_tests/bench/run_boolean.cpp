#include "bench/run_boolean.hpp"

#include <algorithm>

namespace osem::bench {

namespace {

// The boundaries of one row of one operand.
struct Row {
    Row(const RunGrid& grid, std::size_t row)
        : next(grid.boundaries.data() + grid.starts[row]),
          end(grid.boundaries.data() + grid.starts[row + 1]) {}

    bool is_empty() const { return next == end; }
    std::uint32_t position() const { return next == end ? UINT32_MAX : *next; }
    void pass(std::uint32_t at) {
        if (position() != at) return;
        is_inside = !is_inside;
        ++next;
    }

    const std::uint16_t* next;
    const std::uint16_t* end;
    bool is_inside = false;
};

template <class Rule>
std::uint16_t* merge(Row a, Row b, std::uint16_t* to, const Rule& rule) {
    bool is_inside = false;
    while (!a.is_empty() || !b.is_empty()) {
        const std::uint32_t at = std::min(a.position(), b.position());
        a.pass(at);
        b.pass(at);
        if (rule(a.is_inside, b.is_inside) == is_inside) continue;
        is_inside = !is_inside;
        *to++ = static_cast<std::uint16_t>(at);
    }
    return to;
}

template <class Rule>
void combine_rows(const RunGrid& a, const RunGrid& b, RunGrid& result, const Rule& rule) {
    result.side = a.side;
    result.starts.resize(a.starts.size());
    result.boundaries.resize(a.boundaries.size() + b.boundaries.size());
    std::uint16_t* const first = result.boundaries.data();
    std::uint16_t* to = first;
    for (std::size_t row = 0; row + 1 < a.starts.size(); ++row) {
        result.starts[row] = static_cast<std::uint32_t>(to - first);
        const Row in_a(a, row);
        const Row in_b(b, row);
        if (!in_a.is_empty() && !in_b.is_empty()) {
            to = merge(in_a, in_b, to, rule);
            continue;
        }
        if (rule(true, false)) to = std::copy(in_a.next, in_a.end, to);
        if (rule(false, true)) to = std::copy(in_b.next, in_b.end, to);
    }
    result.boundaries.resize(static_cast<std::size_t>(to - first));
    result.starts.back() = static_cast<std::uint32_t>(result.boundaries.size());
}

} // namespace

void combine(Operator op, const RunGrid& a, const RunGrid& b, RunGrid& result) {
    switch (op) {
    case Operator::unite:
        return combine_rows(a, b, result, [](bool in_a, bool in_b) { return in_a || in_b; });
    case Operator::intersect:
        return combine_rows(a, b, result, [](bool in_a, bool in_b) { return in_a && in_b; });
    case Operator::subtract:
        return combine_rows(a, b, result, [](bool in_a, bool in_b) { return in_a && !in_b; });
    case Operator::exclusive_or:
        return combine_rows(a, b, result, [](bool in_a, bool in_b) { return in_a != in_b; });
    }
}

} // namespace osem::bench
