#include "geometry/sight.hpp"

namespace osem {

namespace {

// Counts the edges that pass the line on its right, upwards less downwards. A corner at the height of the
// line is below the moved one, and an edge through the line is on its left.
std::int32_t winding_of_ring(const Solid& solid, const Ring& ring, const Sight& sight) {
    std::int32_t winding = 0;
    Sight::Seen a = sight.see(solid.vertices[ring.corners[ring.count - 1]]);
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        const Sight::Seen b = sight.see(solid.vertices[ring.corners[i]]);
        const bool up = a.v.value() <= 0;
        if (up != (b.v.value() <= 0)) {
            const int side = turn(a, b).sign();
            if (up && side > 0) ++winding;
            if (!up && side < 0) --winding;
        }
        a = b;
    }
    return winding;
}

} // namespace

std::int32_t winding_of_rings(const Solid& solid, std::uint32_t first, std::uint32_t end,
                              const Sight& sight) {
    std::int32_t winding = 0;
    for (; first < end; ++first) winding += winding_of_ring(solid, solid.ring(first), sight);
    return winding;
}

} // namespace osem
