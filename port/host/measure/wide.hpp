// Arithmetic and text of the kernel's 128-bit integers. Sums, differences and products are modulo 2^128, so
// that they serve signed numbers in two's complement as well.
#ifndef OSEM_HOST_WIDE_HPP
#define OSEM_HOST_WIDE_HPP

#include <cstdint>
#include <string>

#include "osem/measure.hpp"

namespace osem::host {

Wide sum(const Wide& a, const Wide& b);
Wide difference(const Wide& a, const Wide& b);
Wide product(const Wide& a, std::uint32_t b);

/// Whether a < b, both unsigned.
bool below(const Wide& a, const Wide& b);

/// The nearest binary64 or one beside it, of a number read as signed.
double approximate(const Wide& a);

/// In decimal digits, read as unsigned.
std::string decimal(const Wide& a);

} // namespace osem::host

#endif
