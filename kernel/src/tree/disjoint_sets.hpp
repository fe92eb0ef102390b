// Disjoint sets over words of the caller: word i holds a lower or equal index of the same set, and the word
// of a set's leader, its lowest index, holds its own. Words in between may serve other ends.
//
// Path halving with linking by index; a sequence of m operations on n elements costs O(m log n) (Tarjan and
// van Leeuwen, "Worst-Case Analysis of Set Union Algorithms", JACM 31(2), 1984), and needs no ranks.
#ifndef OSEM_TREE_DISJOINT_SETS_HPP
#define OSEM_TREE_DISJOINT_SETS_HPP

#include <cstdint>

namespace osem {

/// The leader of the set that holds `element`. Shortens the way for the next one who asks.
inline std::uint32_t leader_of(std::uint32_t* sets, std::uint32_t element) {
    while (sets[element] != element) {
        sets[element] = sets[sets[element]];
        element = sets[element];
    }
    return element;
}

/// Makes one set of two; the lower leader leads it.
inline void unite_sets(std::uint32_t* sets, std::uint32_t a, std::uint32_t b) {
    a = leader_of(sets, a);
    b = leader_of(sets, b);
    if (a < b) {
        sets[b] = a;
    } else {
        sets[a] = b;
    }
}

} // namespace osem

#endif
