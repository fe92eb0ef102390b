#include "grid/row_windings.hpp"

namespace osem {

// One more plane, for numbers of one row that have outgrown theirs: of those the sign is wrong.
void RowWindings::widen(std::uint32_t row, std::uint32_t outgrown) {
    overflowed_ = (planes_ + 2) * rows_ > room_;
    if (overflowed_) return;
    const std::uint32_t* const signs = plane(planes_ - 1);
    std::uint32_t* const added = plane(planes_++);
    for (std::uint32_t r = 0, rows = rows_; r < rows; ++r) added[r] = signs[r];
    added[row] ^= outgrown;
}

void RowWindings::add(std::uint32_t row, std::uint32_t set, std::int32_t number) {
    std::uint32_t left = static_cast<std::uint32_t>(number < 0 ? -std::int64_t{number} : number);
    if (rule_ == WindingRule::odd) left &= 1U;
    for (unsigned from = 0; left != 0; ++from, left >>= 1) {
        if ((left & 1U) == 0) continue;
        while (from > 0 && from + 1 >= planes_ && !overflowed_) widen(0, 0);
        if (overflowed_) return;
        add_power(row, set, from, number > 0);
    }
}

// As add_power of 1, in four rows from this one on.
void RowWindings::add_to_four(std::uint32_t* low, const Four& added, std::uint32_t down) {
    Four set = added;
    Four before = {};
    std::uint32_t* word = low;
    for (unsigned left = planes_; --left != 0; word += rows_) {
        load(before, word);
        store(word, before ^ set);
        set &= before ^ down;
    }
    load(before, word);
    store(word, before ^ set);
    const Four outgrown = set & ~(before ^ down);
    if (any(outgrown) && planes_ > 1) widen_four(low, outgrown);
}

// Of all four the new plane is as of rows whose sign is right.
void RowWindings::widen_four(const std::uint32_t* low, const Four& outgrown) {
    const auto row = static_cast<std::uint32_t>(low - plane(0));
    widen(row, outgrown[0]);
    for (unsigned i = 1; i < 4; ++i) plane(planes_ - 1)[row + i] ^= outgrown[i];
}

// The rows' first numbers from their differences.
void RowWindings::finish(std::int32_t winding) {
    const auto number = static_cast<std::uint32_t>(winding);
    if (level_) {
        // Small parts have no room for two ways on from here.
        const std::uint32_t rows = guesses_cost_much ? 1 : rows_;
        for (std::uint32_t row = 0; row < rows; ++row) first_[row] = number;
        level_ = guesses_cost_much;
        return;
    }
    const std::uint32_t side = std::uint32_t{1} << levels_;
    first_[0] += number;
    for (std::uint32_t row = 1; row < side; ++row) first_[row] += first_[row - 1];
    const std::uint32_t* before = first_;
    for (std::uint32_t* layer = first_ + side; layer != first_ + rows_; layer += side, before += side) {
        for (std::uint32_t row = 0; row < side; ++row) layer[row] += before[row];
    }
}

// What is added to a row's first number is not the number that would make it 0: they differ in any bit, up to
// the sign, which stands for all above it. No point is at 0 where the planes do not hold that number.
template <class FirstOf>
void RowWindings::set_where_not_zero(std::uint32_t* low, FirstOf first_of_row) const {
    const std::uint32_t rows = rows_;
    const unsigned sign_plane = planes_ - 1;
    const std::uint32_t* const sign = plane(sign_plane);
    const std::uint32_t least = std::uint32_t{1} << sign_plane; // below 0 that the planes hold
    std::uint32_t beyond = 0;                                   // bits that no number has which they hold
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t number = 0 - first_of_row(row);
        beyond |= number + least;
        low[row] = (low[row] ^ (0 - (number & 1U))) | (sign[row] ^ (0 - (number >> 31)));
    }
    for (unsigned b = 1; b < sign_plane; ++b) {
        const std::uint32_t* const bits = plane(b);
        for (std::uint32_t row = 0; row < rows; ++row) {
            low[row] |= bits[row] ^ (0 - ((0 - first_of_row(row)) >> b & 1U));
        }
    }
    if (beyond >> sign_plane >> 1 == 0) return;
    for (std::uint32_t row = 0; row < rows; ++row) {
        if ((least - first_of_row(row)) >> sign_plane >> 1 != 0) low[row] = ~std::uint32_t{0};
    }
}

// By the positive rule: what is added to the row's first number is greater than the number that would make
// it 0. That is found from the lowest bit up, each bit deciding before all below it; by the sign, greater is
// what is not below 0.
std::uint32_t RowWindings::inside_of(std::uint32_t row) const {
    const auto number = static_cast<std::int32_t>(0 - first_of(row));
    const unsigned sign_plane = planes_ - 1;
    const std::int32_t sign = number < 0 ? -1 : 0;
    if (number >> sign_plane != sign) return static_cast<std::uint32_t>(sign); // beyond the planes
    std::uint32_t inside = 0;
    for (unsigned b = 0; b < planes_; ++b) {
        const std::uint32_t bit = 0 - (static_cast<std::uint32_t>(number) >> b & 1U);
        const std::uint32_t differing = plane(b)[row] ^ bit;
        const std::uint32_t greater = b == sign_plane ? bit : plane(b)[row];
        inside = (inside & ~differing) | (differing & greater);
    }
    return inside;
}

const std::uint32_t* RowWindings::inside() {
    std::uint32_t* const result = plane(0);
    const std::uint32_t rows = rows_;
    if (rule_ == WindingRule::odd) {
        for (std::uint32_t row = 0; row < rows; ++row) result[row] ^= 0 - (first_of(row) & 1U);
    } else if (rule_ == WindingRule::nonzero) {
        if (guesses_cost_much && level_) {
            set_where_not_zero(result, [number = first_[0]](std::uint32_t) { return number; });
        } else {
            set_where_not_zero(result, [first = first_](std::uint32_t row) { return first[row]; });
        }
    } else {
        for (std::uint32_t row = 0; row < rows; ++row) result[row] = inside_of(row);
    }
    return result;
}

std::int32_t RowWindings::at(std::uint32_t row, unsigned i) const {
    const std::uint32_t sign = rule_ == WindingRule::odd ? 0 : plane(planes_ - 1)[row] >> i & 1U;
    std::uint32_t number = std::uint32_t{0} - sign;
    for (unsigned b = planes_; b-- > 0;) number = number << 1 | (plane(b)[row] >> i & 1U);
    return static_cast<std::int32_t>(first_of(row) + number);
}

} // namespace osem
