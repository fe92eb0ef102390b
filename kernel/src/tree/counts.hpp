// Counts that say "so many or more" at their greatest value.
#ifndef OSEM_TREE_COUNTS_HPP
#define OSEM_TREE_COUNTS_HPP

#include <cstdint>

namespace osem {

constexpr std::uint32_t counted(std::uint32_t count, std::uint32_t more) {
    return more > UINT32_MAX - count ? UINT32_MAX : count + more;
}

} // namespace osem

#endif
