#include "grid/row_windings.hpp"

namespace osem {

// One more plane, for numbers of one row that have outgrown theirs: of those the sign is wrong.
void RowWindings::widen(std::uint32_t row, std::uint32_t outgrown) {
    overflowed_ = overflowed_ || (planes_ + 2) * rows_ > room_;
    if (overflowed_ || planes_ == 32) return; // numbers stay in 32 bits, as sums of crossings do
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
    const std::uint32_t rows = rows_;
    const std::uint32_t side_mask = (std::uint32_t{1} << levels_) - 1;
    if (level_) {
        for (std::uint32_t row = 0; row < rows && winding != 0; ++row) add(row, 0, winding);
        return;
    }
    std::int32_t number = winding;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const auto change = static_cast<std::int32_t>(first_[row]);
        if ((row & side_mask) == 0) {
            winding += change;
            number = winding;
        } else {
            number += change;
        }
        if (number != 0) add(row, 0, number);
    }
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
