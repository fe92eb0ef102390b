// The 48 symmetries of the cube: permutations of the axes with reflections.
#ifndef OSEM_SYMMETRY_HPP
#define OSEM_SYMMETRY_HPP

#include <cstdint>

#include "osem/lattice.hpp"

namespace osem {

/// A symmetry of the root octant about its centre: along axis i the image has what the original has along
/// axis from[i], reversed where bit i of `flips` is set. They are a group under composition, of which the 24
/// rotations are one half. Everything is constexpr and needs no table.
struct Symmetry {
    std::uint8_t from[3]; ///< a permutation of 0, 1, 2
    std::uint8_t flips;   ///< in [0, 8)

    static constexpr Symmetry identity() { return {{0, 1, 2}, 0}; }

    /// Each symmetry once, for n in [0, 48); the first is the identity.
    static constexpr Symmetry nth(unsigned n) {
        const unsigned permutation = n / 8;
        const unsigned first = permutation / 2;
        const unsigned onwards = first + 1 + permutation % 2; // at most 4; axes go round
        const unsigned second = onwards < 3 ? onwards : onwards - 3;
        return {{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
                 static_cast<std::uint8_t>(3 - first - second)},
                static_cast<std::uint8_t>(n % 8)};
    }

    /// Whether the members are in range. What follows requires it.
    constexpr bool is_valid() const {
        const bool in_range = from[0] < 3 && from[1] < 3 && from[2] < 3 && flips < 8;
        return in_range && from[0] != from[1] && from[0] != from[2] && from[1] != from[2];
    }

    /// The image of child k in [0, 8), also of an octant's corner by its three high-side bits.
    constexpr unsigned child(unsigned k) const {
        unsigned image = flips;
        for (unsigned axis = 0; axis < 3; ++axis) image ^= ((k >> from[axis]) & 1U) << axis;
        return image;
    }

    /// The image of a lattice point of the root.
    constexpr Point point(const Point& p) const { return mapped(p, root_side); }

    /// The image of the cell of side 1 with minimum corner p.
    constexpr Point cell(const Point& p) const { return mapped(p, root_side - 1); }

    /// What takes the image back: a.inverse() * a and a * a.inverse() are the identity.
    constexpr Symmetry inverse() const {
        Symmetry back = identity();
        for (unsigned axis = 0; axis < 3; ++axis) {
            back.from[from[axis]] = static_cast<std::uint8_t>(axis);
            const unsigned flip = (unsigned{flips} >> axis) & 1U;
            back.flips = static_cast<std::uint8_t>((back.flips & ~(1U << from[axis])) | (flip << from[axis]));
        }
        return back;
    }

    /// Whether orientation is kept: rotations do, the others mirror.
    constexpr bool is_rotation() const {
        const bool even_permutation = from[1] == (from[0] == 2 ? 0 : from[0] + 1);
        const bool even_flips = ((0x69U >> flips) & 1U) != 0; // 0, 3, 5 and 6 have an even number of bits
        return even_permutation == even_flips;
    }

    /// First b, then a.
    friend constexpr Symmetry operator*(const Symmetry& a, const Symmetry& b) {
        Symmetry both = identity();
        for (unsigned axis = 0; axis < 3; ++axis) {
            both.from[axis] = b.from[a.from[axis]];
            const unsigned flip = (unsigned{b.flips} >> a.from[axis]) & 1U;
            both.flips = static_cast<std::uint8_t>(both.flips | (flip << axis));
        }
        both.flips = static_cast<std::uint8_t>(both.flips ^ a.flips);
        return both;
    }
    friend constexpr bool operator==(const Symmetry& a, const Symmetry& b) {
        return a.from[0] == b.from[0] && a.from[1] == b.from[1] && a.from[2] == b.from[2] &&
               a.flips == b.flips;
    }
    friend constexpr bool operator!=(const Symmetry& a, const Symmetry& b) { return !(a == b); }

  private:
    constexpr Point mapped(const Point& p, std::int32_t far) const {
        Point image = {{0, 0, 0}};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const std::int32_t value = p.at[from[axis]];
            image.at[axis] = ((unsigned{flips} >> axis) & 1U) != 0 ? far - value : value;
        }
        return image;
    }
};

} // namespace osem

#endif
