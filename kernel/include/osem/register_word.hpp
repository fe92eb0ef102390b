// As many bits as are worked on at once.
#ifndef OSEM_REGISTER_WORD_HPP
#define OSEM_REGISTER_WORD_HPP

#include <cstdint>
#include <type_traits>

namespace osem {

/// 64 bits where pointers have as many, as a register holds them there; else 32. What is computed does not
/// depend on it.
using RegisterWord = std::conditional_t<sizeof(void*) == 8, std::uint64_t, std::uint32_t>;

constexpr bool has_wide_registers = sizeof(RegisterWord) == 8;

} // namespace osem

#endif
