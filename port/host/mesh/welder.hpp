// Equal lattice points found as they come.
#ifndef OSEM_HOST_MESH_WELDER_HPP
#define OSEM_HOST_MESH_WELDER_HPP

#include <cstdint>
#include <vector>

#include "osem/lattice.hpp"

namespace osem::host {

/// A hash table over a growing array of different points. Open addressing: a mesh has millions of vertices,
/// and a table of separate nodes would take most of the tool's time.
class Welder {
  public:
    explicit Welder(std::vector<Point>& points) : points_(points), slots_(1024, empty) {}

    /// The index of a point in the array, to which it is appended if it is new.
    std::uint32_t add(const Point& p) {
        std::size_t slot = slot_of(p);
        if (slots_[slot] != empty) return slots_[slot];
        if (2 * (points_.size() + 1) > slots_.size()) {
            grow();
            slot = slot_of(p);
        }
        slots_[slot] = static_cast<std::uint32_t>(points_.size());
        points_.push_back(p);
        return slots_[slot];
    }

  private:
    static constexpr std::uint32_t empty = UINT32_MAX;

    // Where the point is, or where it belongs.
    std::size_t slot_of(const Point& p) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = static_cast<std::size_t>(hash(p)) & mask;
        while (slots_[slot] != empty && points_[slots_[slot]] != p) slot = (slot + 1) & mask;
        return slot;
    }

    // The coordinates side by side, then the mixing steps of splitmix64.
    static std::uint64_t hash(const Point& p) {
        std::uint64_t bits = 0;
        for (const std::int32_t coordinate : p.at) bits = bits << 21 | static_cast<std::uint64_t>(coordinate);
        bits = (bits ^ bits >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
        bits = (bits ^ bits >> 27) * UINT64_C(0x94d049bb133111eb);
        return bits ^ bits >> 31;
    }

    void grow() {
        slots_.assign(2 * slots_.size(), empty);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            slots_[slot_of(points_[i])] = static_cast<std::uint32_t>(i);
        }
    }

    std::vector<Point>& points_;
    std::vector<std::uint32_t> slots_;
};

} // namespace osem::host

#endif
