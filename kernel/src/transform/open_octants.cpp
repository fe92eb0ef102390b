#include "osem/transform.hpp"

namespace osem {

std::uint64_t OpenOctants::decided_volume() const {
    std::uint64_t decided = 0;
    for (int i = 0; i <= level; ++i) {
        const unsigned entered = i < level ? 1 : 0;
        decided += (8 - count_bits(left[i]) - entered) * volume_at(i + 1);
    }
    return decided;
}

} // namespace osem
