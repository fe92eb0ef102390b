// Whether a surface is a cycle, counted plainly: how often each directed edge, by the coordinates of its
// ends, is used more than its opposite.
#ifndef OSEM_ORACLE_DIRECTED_EDGES_HPP
#define OSEM_ORACLE_DIRECTED_EDGES_HPP

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "osem/solid.hpp"

namespace oracle {

class DirectedEdges {
  public:
    explicit DirectedEdges(const osem::Solid& solid) {
        for (std::uint32_t r = 0; r < solid.ring_count(); ++r) {
            const osem::Ring ring = solid.ring(r);
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                const std::uint32_t from = ring.corners[i];
                const std::uint32_t to = ring.corners[(i + 1) % ring.count];
                ++uses_[{key(solid, from), key(solid, to)}];
                used_[{from, to}] = true;
            }
        }
    }

    /// Uses of the edge less uses of its opposite.
    int excess(const osem::Solid& solid, const osem::Edge& edge) const {
        return uses({key(solid, edge.from), key(solid, edge.to)}) -
               uses({key(solid, edge.to), key(solid, edge.from)});
    }

    /// Whether some ring runs from the one vertex index to the other.
    bool has(const osem::Edge& edge) const { return used_.count({edge.from, edge.to}) != 0; }

    bool closed() const {
        for (const auto& [edge, count] : uses_) {
            if (count != uses({edge.second, edge.first})) return false;
        }
        return true;
    }

  private:
    using Key = std::array<std::int32_t, 3>;
    using Place = std::pair<Key, Key>;

    static Key key(const osem::Solid& solid, std::uint32_t vertex) {
        const osem::Point& p = solid.vertices[vertex];
        return {p.x(), p.y(), p.z()};
    }

    int uses(const Place& place) const {
        const auto found = uses_.find(place);
        return found == uses_.end() ? 0 : found->second;
    }

    std::map<Place, int> uses_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> used_;
};

} // namespace oracle

#endif
