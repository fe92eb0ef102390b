#include "measure/mass.hpp"

#include <cmath>

#include "measure/wide.hpp"

namespace osem::host {

namespace {

// The lattice coordinate c with 2 V c <= F < 2 V (c + 1).
std::uint32_t floor_of_centroid(const Wide& first, const Wide& twice_volume) {
    std::uint32_t c = 0;
    for (std::uint32_t bit = std::uint32_t{1} << lattice_bits; bit > 0; bit >>= 1) {
        if (!below(first, product(twice_volume, c + bit))) c += bit;
    }
    return c;
}

// 12 * the product of inertia about the lattice point c: S - 6 (c_a F_b + c_b F_a) + 12 c_a c_b V.
double second_about(const Moments& m, const std::uint32_t* c, unsigned a, unsigned b, unsigned entry) {
    const Wide mixed = sum(product(m.first[b], c[a]), product(m.first[a], c[b]));
    const Wide square = product(product(product(Wide{0, m.volume}, c[a]), c[b]), 12);
    return approximate(sum(difference(m.second[entry], product(mixed, 6)), square));
}

} // namespace

double world_volume(std::uint64_t cells, const WorldCube& cube) {
    const double part = std::ldexp(static_cast<double>(cells), -3 * lattice_bits);
    return part * cube.side * cube.side * cube.side;
}

Mass mass_of(const Moments& m, const WorldCube& cube) {
    const Wide twice_volume = product(Wide{0, m.volume}, 2);
    const auto volume = static_cast<double>(m.volume);
    std::uint32_t c[3];
    double rest[3]; // from c to the centroid, times V
    Mass mass = {};
    for (unsigned a = 0; a < 3; ++a) {
        c[a] = floor_of_centroid(m.first[a], twice_volume);
        rest[a] = approximate(difference(m.first[a], product(twice_volume, c[a]))) / 2;
        mass.centroid[a] = cube.origin[a] + cube.unit() * (c[a] + rest[a] / volume);
    }
    const double unit5 = std::pow(cube.unit(), 5);
    double square[3];
    for (unsigned a = 0; a < 3; ++a) {
        const unsigned b = (a + 1) % 3;
        square[a] = second_about(m, c, a, a, product_xx + a) / 12 - rest[a] * rest[a] / volume;
        const double mixed = second_about(m, c, a, b, product_xy + a) / 12 - rest[a] * rest[b] / volume;
        mass.inertia[3 + a] = mixed == 0 ? 0 : -mixed * unit5;
    }
    for (unsigned a = 0; a < 3; ++a) {
        mass.inertia[a] = (square[(a + 1) % 3] + square[(a + 2) % 3]) * unit5;
    }
    return mass;
}

} // namespace osem::host
