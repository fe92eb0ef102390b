// Edges that wait for one which runs against them, in a hash table.
#ifndef OSEM_SOLID_EDGE_TABLE_HPP
#define OSEM_SOLID_EDGE_TABLE_HPP

#include <cstdint>

#include "osem/solid.hpp"

namespace osem {

/// An open-addressed table with linear probing (Knuth, The Art of Computer Programming, vol. 3, 6.4). Probes
/// end after eight times the binary logarithm of its places: what would need more is refused, so whatever
/// the edges are, n of them take O(n log n).
class EdgeTable {
  public:
    /// An empty table in the caller's memory, of which it takes the greatest power of two.
    EdgeTable(Edge* memory, std::uint32_t room) : places_(memory), size_(room == 0 ? 0 : 1) {
        for (std::uint32_t halved = room / 2; halved != 0; halved /= 2) ++bits_;
        size_ <<= bits_;
        for (std::uint32_t place = 0; place < size_; ++place) places_[place] = empty;
    }

    /// Drops an edge with one between the same vertices that runs against it, or keeps it until such a one
    /// comes. False when there is no place for it: then nothing is changed. Precondition: its vertices'
    /// indices are below 2^32 - 1, and the table has two places at least.
    bool take(const Edge& edge) {
        OSEM_ASSERT(bits_ != 0);
        std::uint32_t place = first_place(edge);
        Edge* free = nullptr;
        for (unsigned probes = 8 * bits_; probes != 0; --probes, place = (place + 1) & (size_ - 1)) {
            Edge& there = places_[place];
            if (there.from == edge.to && there.to == edge.from) {
                there = left;
                return true;
            }
            if (there.from != no_vertex) continue;
            if (free == nullptr) free = &there;
            if (there.to == empty.to) break;
        }
        if (free == nullptr) return false;
        *free = edge;
        return true;
    }

    /// Moves the edges that are kept to the front of the memory; how many.
    std::uint32_t gather() {
        std::uint32_t count = 0;
        for (std::uint32_t place = 0; place < size_; ++place) {
            if (places_[place].from != no_vertex) places_[count++] = places_[place];
        }
        return count;
    }

  private:
    static constexpr std::uint32_t no_vertex = ~std::uint32_t{0};
    static constexpr Edge empty = {no_vertex, 0};
    static constexpr Edge left = {no_vertex, 1}; ///< an edge was here: those behind it are still looked for

    // The same for both directions. Neighbouring indices, as meshes have them, are spread by odd factors.
    std::uint32_t first_place(const Edge& edge) const {
        const bool up = edge.from < edge.to;
        const std::uint32_t low = up ? edge.from : edge.to;
        const std::uint32_t high = up ? edge.to : edge.from;
        return ((low * 0x9e3779b1U + high) * 0x85ebca6bU) >> (32 - bits_);
    }

    Edge* places_;
    std::uint32_t size_;
    unsigned bits_ = 0;
};

} // namespace osem

#endif
