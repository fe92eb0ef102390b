// Four numbers side by side: in one register of parts that have such ones, else in four.
#ifndef OSEM_GRID_FOUR_HPP
#define OSEM_GRID_FOUR_HPP

#include <cstdint>

namespace osem {

using Four [[gnu::vector_size(16)]] = std::uint32_t;

} // namespace osem

#endif
