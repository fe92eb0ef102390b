// Components of faces.
#ifndef OSEM_HOST_MESH_FACE_SETS_HPP
#define OSEM_HOST_MESH_FACE_SETS_HPP

#include <cstdint>
#include <numeric>
#include <vector>

namespace osem::host {

/// Disjoint sets of the numbers below a count, each with a representative: its least member.
class FaceSets {
  public:
    explicit FaceSets(std::uint32_t count) : parent_(count), sets_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    std::uint32_t find(std::uint32_t face) {
        while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]]; // halves the path
        return face;
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return;
        parent_[a < b ? b : a] = a < b ? a : b;
        --sets_;
    }

    /// How many sets there are.
    std::uint32_t count() const { return sets_; }

  private:
    std::vector<std::uint32_t> parent_;
    std::uint32_t sets_;
};

} // namespace osem::host

#endif
