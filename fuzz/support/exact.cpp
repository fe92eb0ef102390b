#include "support/exact.hpp"

#include <algorithm>
#include <stdexcept>

namespace osem::fuzz {

namespace {

// A rational number of small terms: differences of lattice coordinates.
struct Fraction {
    std::int64_t numerator;
    std::int64_t denominator; // above 0
    bool operator<(const Fraction& other) const {
        return numerator * other.denominator < other.numerator * denominator;
    }
};

Fraction quotient(std::int32_t numerator, std::int32_t denominator) {
    const bool negative = denominator < 0;
    return {negative ? -std::int64_t{numerator} : numerator,
            negative ? -std::int64_t{denominator} : denominator};
}

// Whether the closed segment shares a point with the open box: along every axis the parameters in the box are
// an open interval, and [0, 1] has a point in all of them.
bool segment_meets(const Point& a, const Point& b, const OpenBox& box) {
    Fraction from = {-1, 1};
    Fraction to = {2, 1};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t way = b.at[axis] - a.at[axis];
        if (way == 0) {
            if (a.at[axis] <= box.low.at[axis] || a.at[axis] >= box.high.at[axis]) return false;
            continue;
        }
        Fraction in = quotient(box.low.at[axis] - a.at[axis], way);
        Fraction out = quotient(box.high.at[axis] - a.at[axis], way);
        if (out < in) std::swap(in, out);
        from = std::max(from, in);
        to = std::min(to, out);
    }
    return from < to && from < Fraction{1, 1} && Fraction{0, 1} < to;
}

Point corner_of(const OpenBox& box, unsigned k) {
    Point p = box.low;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (((k >> axis) & 1U) != 0) p.at[axis] = box.high.at[axis];
    }
    return p;
}

mpz_class times_power(const mpz_class& value, unsigned bits) { return value << bits; }

} // namespace

ScaledPoint scaled(const Point& p) { return {{mpz_class(p.x()), mpz_class(p.y()), mpz_class(p.z())}, 0}; }

ScaledPoint perturbed(const Point& p) {
    ScaledPoint moved = scaled(p);
    moved.bits = 300;
    for (unsigned axis = 0; axis < 3; ++axis) {
        mpz_class& at = moved.at[axis];
        at = times_power(at, 300) + times_power(mpz_class(1), 200 - 100 * axis);
    }
    return moved;
}

ScaledPoint centre(const Octant& octant, bool moved) {
    if (moved) {
        const std::int32_t half = octant.side() / 2;
        return perturbed({{octant.corner.x() + half, octant.corner.y() + half, octant.corner.z() + half}});
    }
    ScaledPoint middle = {{}, 1};
    for (unsigned axis = 0; axis < 3; ++axis) middle.at[axis] = 2 * octant.corner.at[axis] + octant.side();
    return middle;
}

OpenBox open_box(const Octant& octant) {
    OpenBox box = {octant.corner, octant.corner};
    for (std::int32_t& at : box.high.at) at += octant.side();
    return box;
}

// The normal of the first three corners that are not on one line.
ExactFace::ExactFace(const Solid& solid, std::uint32_t face) {
    std::vector<Point> all;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        rings_.emplace_back();
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            rings_.back().push_back(solid.vertices[ring.corners[i]]);
            all.push_back(rings_.back().back());
        }
    }
    const Point& base = all.front();
    for (std::size_t i = 1; i < all.size() && axis_ < 0; ++i) {
        for (std::size_t j = i + 1; j < all.size() && axis_ < 0; ++j) {
            for (unsigned axis = 0; axis < 3; ++axis) {
                const unsigned u = (axis + 1) % 3;
                const unsigned v = (axis + 2) % 3;
                normal_[axis] = mpz_class(all[i].at[u] - base.at[u]) * (all[j].at[v] - base.at[v]) -
                                mpz_class(all[i].at[v] - base.at[v]) * (all[j].at[u] - base.at[u]);
                if (normal_[axis] != 0) axis_ = static_cast<int>(axis);
            }
        }
    }
}

mpz_class ExactFace::side(const ScaledPoint& p) const {
    mpz_class value = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        value += normal_[axis] * (p.at[axis] - times_power(mpz_class(rings_[0][0].at[axis]), p.bits));
    }
    return value;
}

bool ExactFace::is_planar() const {
    for (const auto& ring : rings_) {
        for (const Point& corner : ring) {
            if (side(scaled(corner)) != 0) return false;
        }
    }
    return true;
}

bool ExactFace::box_meets(const OpenBox& box) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
        std::int32_t low = INT32_MAX;
        std::int32_t high = INT32_MIN;
        for (const auto& ring : rings_) {
            for (const Point& corner : ring) {
                low = std::min(low, corner.at[axis]);
                high = std::max(high, corner.at[axis]);
            }
        }
        if (high <= box.low.at[axis] || low >= box.high.at[axis]) return false;
    }
    return true;
}

bool ExactFace::plane_meets(const OpenBox& box) const {
    bool above = false;
    bool below = false;
    for (unsigned k = 0; k < 8; ++k) {
        const int sign = sgn(side(scaled(corner_of(box, k))));
        above = above || sign > 0;
        below = below || sign < 0;
    }
    return above && below;
}

std::vector<std::array<mpq_class, 3>> ExactFace::section(const OpenBox& box) const {
    std::vector<std::array<mpq_class, 3>> corners;
    for (unsigned k = 0; k < 8; ++k) {
        const Point a = corner_of(box, k);
        const mpz_class at_a = side(scaled(a));
        if (at_a == 0) corners.push_back({mpq_class(a.x()), mpq_class(a.y()), mpq_class(a.z())});
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (((k >> axis) & 1U) != 0) continue;
            const Point b = corner_of(box, k | (1U << axis));
            const mpz_class at_b = side(scaled(b));
            if (sgn(at_a) * sgn(at_b) >= 0) continue;
            std::array<mpq_class, 3> cut = {mpq_class(a.x()), mpq_class(a.y()), mpq_class(a.z())};
            mpq_class way(at_a, at_a - at_b);
            way.canonicalize();
            cut[axis] += way * (b.at[axis] - a.at[axis]);
            corners.push_back(cut);
        }
    }
    return corners;
}

// Where no edge meets the open box all of the section is on one side of every ring, so its corners' mean,
// which is in the open box, decides.
bool ExactFace::meets(const OpenBox& box) const {
    if (!box_meets(box)) return false;
    for (const auto& ring : rings_) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (segment_meets(ring[i], ring[(i + 1) % ring.size()], box)) return true;
        }
    }
    if (!has_area() || !plane_meets(box)) return false;
    const auto corners = section(box);
    const auto u = static_cast<std::size_t>((axis_ + 1) % 3);
    const auto v = static_cast<std::size_t>((axis_ + 2) % 3);
    mpq_class mean_u = 0;
    mpq_class mean_v = 0;
    for (const auto& corner : corners) {
        mean_u += corner[u];
        mean_v += corner[v];
    }
    mean_u /= static_cast<unsigned long>(corners.size());
    mean_v /= static_cast<unsigned long>(corners.size());
    const std::optional<int> around =
        winding(mean_u.get_num() * mean_v.get_den(), mean_v.get_num() * mean_u.get_den(),
                mean_u.get_den() * mean_v.get_den());
    if (!around) throw std::logic_error("a ring in a box that no edge meets");
    return *around != 0;
}

std::optional<int> ExactFace::winding(const mpz_class& u, const mpz_class& v, const mpz_class& w) const {
    const auto first = static_cast<std::size_t>((axis_ + 1) % 3);
    const auto second = static_cast<std::size_t>((axis_ + 2) % 3);
    int around = 0;
    for (const auto& ring : rings_) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& a = ring[i];
            const Point& b = ring[(i + 1) % ring.size()];
            const mpz_class a_u = u - w * a.at[first];
            const mpz_class a_v = v - w * a.at[second];
            const mpz_class b_v = v - w * b.at[second];
            const int turn = sgn((b.at[first] - a.at[first]) * a_v - (b.at[second] - a.at[second]) * a_u);
            if (turn == 0 && sgn(a_u) * sgn(u - w * b.at[first]) <= 0 && sgn(a_v) * sgn(b_v) <= 0)
                return std::nullopt;
            if (sgn(a_v) >= 0 && sgn(b_v) < 0 && turn > 0) ++around;
            if (sgn(b_v) >= 0 && sgn(a_v) < 0 && turn < 0) --around;
        }
    }
    return sgn(normal_[static_cast<std::size_t>(axis_)]) > 0 ? around : -around;
}

std::optional<int> ExactFace::change(const ScaledPoint& p, const ScaledPoint& q) const {
    if (!has_area()) return 0;
    const mpz_class at_p = side(p);
    const mpz_class at_q = side(q);
    if (sgn(at_p) == sgn(at_q)) return sgn(at_p) == 0 ? std::nullopt : std::optional<int>(0);
    const auto u = static_cast<std::size_t>((axis_ + 1) % 3);
    const auto v = static_cast<std::size_t>((axis_ + 2) % 3);
    if (sgn(at_p) == 0 || sgn(at_q) == 0) {
        const ScaledPoint& end = sgn(at_p) == 0 ? p : q;
        const std::optional<int> around = winding(end.at[u], end.at[v], times_power(mpz_class(1), end.bits));
        return around == 0 ? around : std::nullopt;
    }
    mpz_class cut_u = p.at[u] * at_q - q.at[u] * at_p;
    mpz_class cut_v = p.at[v] * at_q - q.at[v] * at_p;
    mpz_class scale = times_power(at_q - at_p, p.bits);
    if (sgn(scale) < 0) {
        cut_u = -cut_u;
        cut_v = -cut_v;
        scale = -scale;
    }
    const std::optional<int> around = winding(cut_u, cut_v, scale);
    if (!around) return std::nullopt;
    return sgn(at_q) > 0 ? -*around : *around; // out through the front lowers the number
}

ExactSolid::ExactSolid(const Solid& solid) {
    for (std::uint32_t face = 0; face < solid.face_count; ++face) faces_.emplace_back(solid, face);
}

std::vector<std::size_t> ExactSolid::meeting(const std::vector<std::size_t>& faces,
                                             const Octant& octant) const {
    std::vector<std::size_t> met;
    const OpenBox box = open_box(octant);
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(met),
                 [&](std::size_t face) { return faces_[face].meets(box); });
    return met;
}

// Ways that rarely run along anything; each is longer than the root is wide. One that does is not taken.
int ExactSolid::winding(const ScaledPoint& p) const {
    for (int turn = 0; turn < 40; ++turn) {
        ScaledPoint q = p;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const long way = axis == static_cast<unsigned>(turn) % 3
                                 ? 2097169 + 34 * turn
                                 : 104729 * (turn + 1) - 77977 * static_cast<long>(axis);
            q.at[axis] += times_power(mpz_class(turn % 2 == 0 ? way : -way), p.bits);
        }
        std::optional<int> sum = 0;
        for (const ExactFace& face : faces_) {
            const std::optional<int> change = face.change(p, q);
            sum = sum && change ? std::optional<int>(*sum + *change) : std::nullopt;
            if (!sum) break;
        }
        if (sum) return -*sum; // outside the number is 0
    }
    throw std::logic_error("every way out of the root is degenerate");
}

} // namespace osem::fuzz
