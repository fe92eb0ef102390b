// Random numbers of a range.
#ifndef OSEM_SUPPORT_RANDOM_IN_HPP
#define OSEM_SUPPORT_RANDOM_IN_HPP

#include <random>

namespace osem::tests {

inline int random_in(std::mt19937& random, int first, int last) {
    return std::uniform_int_distribution<int>(first, last)(random);
}

} // namespace osem::tests

#endif
