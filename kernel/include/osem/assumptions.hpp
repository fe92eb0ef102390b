// What the kernel takes for granted of a compiler and a processor beyond what C++17 promises. A target on
// which one of these fails does not compile. kernel/DESIGN.md says where each is used.
#ifndef OSEM_ASSUMPTIONS_HPP
#define OSEM_ASSUMPTIONS_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace osem {

// The exact-width types exist, so bytes have 8 bits, and signed numbers are two's complement without padding.
static_assert(static_cast<unsigned char>(-1) == 0xff && (-1 & 0xff) == 0xff,
              "bytes of 8 bits, two's complement");

// What C++17 leaves to the implementation, and C++20 demands.
static_assert((std::int32_t{-5} >> 1) == -3 && (std::int64_t{-5} >> 1) == -3, "right shifts round down");
static_assert(static_cast<std::int8_t>(std::uint8_t{0xff}) == -1 &&
                  static_cast<std::int32_t>(std::uint32_t{0xffffffff}) == -1 &&
                  static_cast<std::int64_t>(std::uint64_t{0xffffffffffffffff}) == -1,
              "conversion to a signed type keeps the bits");

// Operands narrower than int are widened to int, constants of 32 bits are unsigned int, and products of these
// wrap around at 2^32.
static_assert(sizeof(int) == 4, "int of 32 bits");

// Words of scratch, nodes and corners have numbers of 32 bits.
static_assert(sizeof(std::size_t) >= 4, "arrays of 2^32 bytes can be indexed");
static_assert(sizeof(std::ptrdiff_t) >= 4, "and so can what lies between two of their elements");

// Grids keep tables of bytes in the caller's words: character types may stand for any object.
static_assert(std::is_same<std::uint8_t, unsigned char>::value, "uint8_t is a character type");
static_assert(std::is_same<std::int8_t, signed char>::value, "int8_t is a character type");

} // namespace osem

#endif
