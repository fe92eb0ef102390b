// What moments on the lattice are in the world: volume, centroid, inertia of unit density.
#ifndef OSEM_HOST_MASS_HPP
#define OSEM_HOST_MASS_HPP

#include <cstdint>

#include "mesh/quantize.hpp"
#include "osem/measure.hpp"

namespace osem::host {

/// A volume of lattice cells in cubed world units.
double world_volume(std::uint64_t cells, const WorldCube& cube);

/// Centroid and inertia tensor about it: Ixx, Iyy, Izz, then the products Ixy, Iyz, Izx, negated integrals.
struct Mass {
    double centroid[3];
    double inertia[6];
};

/// Rounded at the end only: what large numbers cancel is taken away in integers, by moving the origin to the
/// lattice point below the centroid. Precondition: volume > 0.
Mass mass_of(const Moments& moments, const WorldCube& cube);

} // namespace osem::host

#endif
