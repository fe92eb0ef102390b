// Winding numbers of a grid's points against numbers added up one by one.
#include "grid/row_windings.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace osem::tests {

namespace {

constexpr std::size_t planes = 8; // numbers are below 2^7: twelve of 9 at most are added, and twelve of 1

class Numbers {
  public:
    Numbers(int levels, WindingRule rule)
        : side_(1 << levels), rule_(rule), numbers_(static_cast<std::size_t>(side_ * side_ * side_)),
          words_(static_cast<std::size_t>(side_ * side_) * (planes + 1), 0xdeadbeef),
          windings_(words_.data(), static_cast<std::uint32_t>(words_.size()), levels, rule) {}

    // Rows from (j, k) on, of the same k, from point first on in the first of them and one further in each.
    void add_behind(int j, int k, int count, int first, std::int32_t number) {
        const auto row = static_cast<std::uint32_t>(j + k * side_);
        PlaneStair last({1, 1}, first - 1, side_ - 1, 0);
        windings_.add_behind(row, row + static_cast<std::uint32_t>(count), last, number);
        for (int r = 0; r < count; ++r) {
            const int begin = first + r;
            if (begin < 1 || begin >= side_) continue; // none, or all that there are
            for (int i = begin; i < side_; ++i) at(i, j + r, k) += number;
        }
    }

    // Four rows from (j, k) on, and so many layers. Nothing is added to a row behind a point before its first
    // one, nor behind its last one.
    template <class Point>
    void add_behind_four(int j, int k, int layers, Point point, std::int32_t number) {
        RowWindings::FourRows rows(windings_, j + k * side_, number);
        for (int layer = k; layer < k + layers; ++layer, rows.next_layer()) {
            Four points = {};
            for (int r = 0; r < 4; ++r) {
                const int last = point();
                const bool is_there = last >= 0 && last < side_ - 1;
                points[r] = is_there ? static_cast<std::uint32_t>(last) : ~std::uint32_t{0};
                for (int i = last + 1; is_there && i < side_; ++i) at(i, j + r, layer) += number;
            }
            Four behind = {};
            set_bits_above(behind, points);
            rows.add(behind);
        }
    }

    void change_first(int j, int k, std::int32_t number) {
        windings_.change_first(j + k * side_, number);
        for (int row = j; row < side_; ++row) {
            if (k > 0 && row > j) break; // of row (j, 0) all rows behind change
            for (int layer = k; layer < side_; ++layer) {
                for (int i = 0; i < side_; ++i) at(i, row, layer) += number;
            }
        }
    }

    void finish_and_compare(std::int32_t winding) {
        ASSERT_FALSE(windings_.overflowed());
        if (rule_ == WindingRule::odd) {
            ASSERT_EQ(windings_.words_used(), static_cast<std::uint32_t>(2 * side_ * side_)); // one plane
        }
        windings_.finish(winding);
        for (int r = 0; r < side_ * side_; ++r) {
            for (int i = 0; i < side_; ++i) {
                const std::int32_t expected = winding + at(i, r % side_, r / side_);
                const std::int32_t number =
                    windings_.at(static_cast<std::uint32_t>(r), static_cast<unsigned>(i));
                if (rule_ == WindingRule::odd) {
                    ASSERT_EQ(number & 1, expected & 1);
                } else {
                    ASSERT_EQ(number, expected);
                }
            }
        }
        const std::uint32_t* const inside = windings_.inside();
        for (int r = 0; r < side_ * side_; ++r) {
            for (int i = 0; i < side_; ++i) {
                ASSERT_EQ((inside[r] >> i & 1U) != 0, is_inside(winding + at(i, r % side_, r / side_)))
                    << winding << " and " << at(i, r % side_, r / side_);
            }
        }
    }

  private:
    std::int32_t& at(int i, int j, int k) {
        return numbers_[static_cast<std::size_t>(i + side_ * (j + side_ * k))];
    }
    bool is_inside(std::int32_t number) const {
        if (rule_ == WindingRule::odd) return number % 2 != 0;
        return rule_ == WindingRule::positive ? number > 0 : number != 0;
    }

    int side_;
    WindingRule rule_;
    std::vector<std::int32_t> numbers_;
    std::vector<std::uint32_t> words_;
    RowWindings windings_;
};

class RowWindingsOfRule : public testing::TestWithParam<WindingRule> {};

TEST_P(RowWindingsOfRule, AreTheNumbersAddedUpOneByOne) {
    std::mt19937 random(5);
    const auto up_to = [&random](int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random);
    };
    for (int trial = 0; trial < 300; ++trial) {
        const int levels = up_to(1, 5);
        const int side = 1 << levels;
        const int most = up_to(0, 3) == 0 ? 9 : 1; // mostly numbers of one
        Numbers numbers(levels, GetParam());
        for (int adding = up_to(0, 12); adding > 0; --adding) {
            const int number = up_to(0, 1) == 0 ? up_to(1, most) : -up_to(1, most);
            const int j = up_to(0, side - 1);
            numbers.add_behind(j, up_to(0, side - 1), up_to(0, side - j), up_to(-2, side), number);
        }
        for (int adding = levels > 1 ? up_to(0, 12) : 0; adding > 0; --adding) {
            const int k = up_to(0, side - 1);
            numbers.add_behind_four(
                up_to(0, side - 4), k, up_to(0, side - k), [&] { return up_to(-2, side); },
                up_to(0, 1) == 0 ? 1 : -1);
        }
        for (int change = up_to(0, 3); change > 0; --change) {
            numbers.change_first(up_to(0, side - 1), up_to(0, side - 1), up_to(-2, 2));
        }
        numbers.finish_and_compare(up_to(-4, 4));
    }
}

// Eight needs five planes, one for the sign, and there is room for three.
TEST(RowWindings, ANumberWithoutRoom) {
    std::vector<std::uint32_t> words(16 * 4);
    RowWindings windings(words.data(), 16 * 4, 2, WindingRule::nonzero);
    PlaneStair last({1, 0}, 1, 3, 0);
    windings.add_behind(0, 1, last, 3);
    EXPECT_FALSE(windings.overflowed());
    windings.add_behind(1, 2, last, 8);
    EXPECT_TRUE(windings.overflowed());
}

// Nor is there for four rows that outgrow their planes, one of them or all at once.
TEST(RowWindings, FourRowsWithoutRoom) {
    constexpr std::uint32_t behind_first = ~std::uint32_t{1};
    Four some[5] = {Four{} + behind_first};
    for (unsigned row = 0; row < 4; ++row)
        some[row + 1][row] = behind_first; // nothing is added to the others
    for (const Four& points : some) {
        for (const unsigned room : {3U, 4U}) { // for two planes or three, which hold numbers up to 1 or 3
            std::vector<std::uint32_t> words(std::size_t{16} * room);
            RowWindings windings(words.data(), 16 * room, 2, WindingRule::nonzero);
            for (unsigned times = room == 3 ? 1 : 3; times > 0; --times) {
                RowWindings::FourRows(windings, 4, 1).add(points);
                EXPECT_FALSE(windings.overflowed());
            }
            RowWindings::FourRows(windings, 4, 1).add(points);
            EXPECT_TRUE(windings.overflowed());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, RowWindingsOfRule,
                         testing::Values(WindingRule::nonzero, WindingRule::odd, WindingRule::positive));

} // namespace

} // namespace osem::tests
