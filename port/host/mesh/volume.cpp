#include "mesh/volume.hpp"

#include <cmath>

namespace osem::host {

void WideSum::add(std::int64_t term) {
    const std::uint64_t before = low_;
    low_ += static_cast<std::uint64_t>(term);
    if (low_ < before) ++high_;
    if (term < 0) --high_;
}

double WideSum::value() const {
    // The magnitude first: the two words of a small negative number would cancel only after rounding.
    const bool negative = high_ < 0;
    const std::uint64_t low = negative ? ~low_ + 1 : low_;
    const std::uint64_t high = negative ? ~static_cast<std::uint64_t>(high_) + (low == 0 ? 1 : 0)
                                        : static_cast<std::uint64_t>(high_);
    const double magnitude = std::ldexp(static_cast<double>(high), 64) + static_cast<double>(low);
    return negative ? -magnitude : magnitude;
}

namespace {

// Coordinates are in [0, 2^20], so a partial sum is at most 3 * 2^60 in magnitude.
std::int64_t determinant(const Point& a, const Point& b, const Point& c) {
    const auto product = [](std::int32_t x, std::int32_t y, std::int32_t z) {
        return std::int64_t{x} * y * z;
    };
    return product(a.x(), b.y(), c.z()) + product(a.y(), b.z(), c.x()) + product(a.z(), b.x(), c.y()) -
           product(a.z(), b.y(), c.x()) - product(a.y(), b.x(), c.z()) - product(a.x(), b.z(), c.y());
}

} // namespace

void add_volume6(WideSum& sum, const Solid& solid, std::uint32_t face) {
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        for (std::uint32_t i = 1; i + 1 < ring.count; ++i) {
            sum.add(determinant(solid.vertices[ring.corners[0]], solid.vertices[ring.corners[i]],
                                solid.vertices[ring.corners[i + 1]]));
        }
    }
}

} // namespace osem::host
