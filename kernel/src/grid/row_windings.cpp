#include "grid/row_windings.hpp"

namespace osem {

// One more plane, for numbers of one row that have outgrown theirs: of those the sign is wrong.
void RowWindings::widen(std::uint32_t row, std::uint32_t outgrown) {
    overflowed_ = overflowed_ || (planes_ + 2) * rows_ > room_;
    if (overflowed_) return;
    const std::uint32_t* const signs = plane(planes_ - 1);
    std::uint32_t* const added = plane(planes_++);
    for (std::uint32_t r = 0, rows = rows_; r < rows; ++r) added[r] = signs[r];
    added[row] ^= outgrown;
}

void RowWindings::add_many(std::uint32_t row, std::uint32_t set, std::int32_t number) {
    std::uint32_t left = static_cast<std::uint32_t>(number < 0 ? -std::int64_t{number} : number);
    if (rule_ == WindingRule::odd) left &= 1U;
    for (unsigned from = 0; left != 0; ++from, left >>= 1) {
        if ((left & 1U) == 0) continue;
        while (from > 0 && from + 1 >= planes_ && !overflowed_) widen(0, 0);
        if (overflowed_) return;
        add_power(row, set, from, number > 0);
    }
}

void RowWindings::finish(std::int32_t winding) {
    if (level_ && winding == 0) return;
    sum_firsts(winding);
    if (raise_rows()) return;
    for (std::uint32_t row = 0, rows = rows_; row < rows; ++row) {
        const auto number = static_cast<std::int32_t>(first_[row]);
        if (number != 0) add(row, 0, number);
    }
}

// The rows' first numbers from their differences.
void RowWindings::sum_firsts(std::int32_t winding) {
    const std::uint32_t side_mask = (std::uint32_t{1} << levels_) - 1;
    auto first = static_cast<std::uint32_t>(winding);
    std::uint32_t number = first;
    for (std::uint32_t row = 0, rows = rows_; row < rows; ++row) {
        number += first_[row];
        if ((row & side_mask) == 0) {
            first += first_[row];
            number = first;
        }
        first_[row] = number;
    }
}

// Raises all rows by their first numbers at once, if there are two planes and they are enough: -2 to 1 has
// its lowest bit and its sign, which each stand for a whole word.
bool RowWindings::raise_rows() {
    if (planes_ != 2) return false;
    const std::uint32_t rows = rows_;
    const std::uint32_t* const first = first_;
    std::uint32_t* const low = plane(0);
    std::uint32_t* const sign = plane(1);
    std::uint32_t outgrown = 0;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t number_sign = 0 - (first[row] >> 31);
        const std::uint32_t carry = low[row] & (0 - (first[row] & 1U));
        const std::uint32_t sum = sign[row] ^ number_sign ^ carry;
        outgrown |= ((first[row] + 2) >> 2) | (~(sign[row] ^ number_sign) & (sign[row] ^ sum));
    }
    if (outgrown != 0) return false;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t number_low = 0 - (first[row] & 1U);
        sign[row] ^= (0 - (first[row] >> 31)) ^ (low[row] & number_low);
        low[row] ^= number_low;
    }
    return true;
}

void RowWindings::inside(std::uint32_t* rows) const {
    const std::uint32_t* const lowest = plane(0);
    const std::uint32_t* const signs = plane(planes_ - 1);
    const std::uint32_t count = rows_;
    const unsigned planes = planes_;
    for (std::uint32_t row = 0; row < count; ++row) rows[row] = lowest[row];
    if (rule_ == WindingRule::odd) return;
    for (unsigned b = 1; b < planes; ++b) {
        const std::uint32_t* const bits = plane(b);
        for (std::uint32_t row = 0; row < count; ++row) rows[row] |= bits[row];
    }
    if (rule_ == WindingRule::nonzero) return;
    for (std::uint32_t row = 0; row < count; ++row) rows[row] &= ~signs[row];
}

std::int32_t RowWindings::at(std::uint32_t row, unsigned i) const {
    const std::uint32_t sign = rule_ == WindingRule::odd ? 0 : plane(planes_ - 1)[row] >> i & 1U;
    std::uint32_t number = std::uint32_t{0} - sign;
    for (unsigned b = planes_; b-- > 0;) number = number << 1 | (plane(b)[row] >> i & 1U);
    return static_cast<std::int32_t>(number);
}

} // namespace osem
