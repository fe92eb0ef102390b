// Winding numbers of the 64 reference points of a grid, added up side by side.
#ifndef OSEM_GRID_WINDING_LANES_HPP
#define OSEM_GRID_WINDING_LANES_HPP

#include <cstdint>

#include "osem/convert.hpp"

namespace osem {

/// 64 numbers in two's complement, bit b of all of them in one word. So adding 1 to a set of them is a carry
/// from word to word, and how many words there are grows with the number of additions: by then no sum can
/// have outgrown them. Every number stays in 32 bits, as sums of crossings do.
class WindingLanes {
  public:
    /// Words that they may need; the caller's, so that no stack holds them.
    static constexpr unsigned most_words = 32;

    /// All 64 are `start`.
    WindingLanes(std::uint64_t (&words)[most_words], std::int32_t start) : word_(words) {
        const std::uint32_t size =
            start < 0 ? ~static_cast<std::uint32_t>(start) : static_cast<std::uint32_t>(start);
        while ((size >> (words_ - 1)) != 0) ++words_;
        for (unsigned b = 0; b < words_; ++b) {
            word_[b] = (static_cast<std::uint32_t>(start) >> b & 1U) != 0 ? ~std::uint64_t{0} : 0;
        }
        room_ = (std::uint32_t{1} << (words_ - 1)) - 1 - size;
    }

    /// Adds 1 (or -1) to the numbers of a set.
    void add(std::uint64_t set, bool up) {
        if (set == 0) return;
        if (room_ == 0) widen();
        --room_;
        for (unsigned b = 0; b < words_ && set != 0; ++b) {
            const std::uint64_t before = word_[b];
            word_[b] ^= set;
            set &= up ? before : ~before;
        }
    }

    /// The numbers that are inside by a rule.
    std::uint64_t inside(WindingRule rule) const {
        if (rule == WindingRule::odd) return word_[0];
        std::uint64_t any = 0;
        for (unsigned b = 0; b < words_; ++b) any |= word_[b];
        return rule == WindingRule::nonzero ? any : any & ~word_[words_ - 1];
    }

    std::int32_t at(unsigned place) const {
        std::uint32_t number = (word_[words_ - 1] >> place & 1U) != 0 ? ~std::uint32_t{0} : 0;
        for (unsigned b = words_; b-- > 0;) {
            number = number << 1 | static_cast<std::uint32_t>(word_[b] >> place & 1U);
        }
        return static_cast<std::int32_t>(number);
    }

  private:
    void widen() {
        if (words_ == most_words) {
            room_ = UINT32_MAX;
            return;
        }
        word_[words_] = word_[words_ - 1];
        room_ = std::uint32_t{1} << (words_ - 1);
        ++words_;
    }

    unsigned words_ = 1;
    std::uint32_t room_ = 0; ///< additions until a sum could outgrow the words
    std::uint64_t* word_;
};

} // namespace osem

#endif
