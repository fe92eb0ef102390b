// Face neighbours and the nearest leaf.
#include "features/roots.hpp"

#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"

namespace {

using Nearest = osem::NearestOutcome (*)(const osem::Octree&, const osem::CellBox&, std::uint8_t,
                                         std::uint64_t);

} // namespace

extern "C" {
auto nearest_roots = roots_of(&osem::face_neighbour, static_cast<Nearest>(&osem::nearest_leaf));
}
