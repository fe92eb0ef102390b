#include "support/lattice_faces.hpp"

#include <algorithm>
#include <numeric>

namespace osem::tests {

namespace {

using Vector = std::array<std::int64_t, 3>;

Vector vector_of(int i) {
    const Halves p = lattice_point(i);
    return {p[0], p[1], p[2]};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector normal_of(int a, int b, int c) {
    return cross(minus(vector_of(b), vector_of(a)), minus(vector_of(c), vector_of(a)));
}

// A point (x, y, z) / w in lowest terms, w > 0. Corners of pieces lie on two lines of lattice points or sides
// of boxes in one plane, so their denominators stay below 2^14.
struct Rational {
    Vector at;
    std::int64_t w;
};
using Piece = std::vector<Rational>; // a convex polygon; it may be a segment or a point

Rational rational(int i) { return {vector_of(i), 1}; }

// Where the value of a linear function, of which a has `at_a` and b `at_b` of the other sign, is 0.
Rational between(const Rational& a, std::int64_t at_a, const Rational& b, std::int64_t at_b) {
    const std::int64_t of_a = at_b < 0 ? -at_b : at_b;
    const std::int64_t of_b = at_a < 0 ? -at_a : at_a;
    Rational cut = {{}, a.w * of_a + b.w * of_b};
    std::int64_t common = cut.w;
    for (std::size_t k = 0; k < 3; ++k) {
        cut.at[k] = a.at[k] * of_a + b.at[k] * of_b;
        common = std::gcd(common, cut.at[k]);
    }
    for (std::int64_t& coordinate : cut.at) coordinate /= common;
    cut.w /= common;
    return cut;
}

// Sutherland and Hodgman: the part where a function, times w, is not below 0.
template <class Value>
void clip(const Piece& piece, const Value& value, Piece& kept) {
    kept.clear();
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const Rational& a = piece[i];
        const Rational& b = piece[i + 1 == piece.size() ? 0 : i + 1];
        const std::int64_t at_a = value(a);
        const std::int64_t at_b = value(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) kept.push_back(between(a, at_a, b, at_b));
    }
}

// The part within a closed interval along an axis, unless all of it is on one end.
bool clip_to(const Piece& piece, std::size_t axis, const Interval& interval, Piece& space, Piece& kept) {
    const auto above = [&](const Rational& p) { return p.at[axis] - interval.low * p.w; };
    const auto below = [&](const Rational& p) { return interval.high * p.w - p.at[axis]; };
    clip(piece, above, space);
    clip(space, below, kept);
    const auto any = [&](const auto& value) {
        return std::any_of(kept.begin(), kept.end(), [&](const Rational& p) { return value(p) > 0; });
    };
    return any(above) && any(below);
}

// Whether a piece within the closed box is off each of its sides. It is convex, so then the mean of its
// corners is in the open box.
bool is_off_sides(const Piece& piece, const std::array<Interval, 3>& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bool above = false;
        bool below = false;
        for (const Rational& p : piece) {
            above = above || p.at[axis] > box[axis].low * p.w;
            below = below || p.at[axis] < box[axis].high * p.w;
        }
        if (!above || !below) return false;
    }
    return true;
}

void mark(const Piece& piece, const BoxForm& form, std::vector<bool>& met) {
    static thread_local std::array<Piece, 4> kept;
    for (std::size_t x = 0; x < form[0].size(); ++x) {
        if (!clip_to(piece, 0, form[0][x], kept[3], kept[0])) continue;
        for (std::size_t y = 0; y < form[1].size(); ++y) {
            if (!clip_to(kept[0], 1, form[1][y], kept[3], kept[1])) continue;
            for (std::size_t z = 0; z < form[2].size(); ++z) {
                if (!clip_to(kept[1], 2, form[2][z], kept[3], kept[2])) continue;
                if (!is_off_sides(kept[2], {form[0][x], form[1][y], form[2][z]})) continue;
                met[x + form[0].size() * (y + form[1].size() * z)] = true;
            }
        }
    }
}

// How two triangles of a plane with one side in common lie: > 0 the same way round, < 0 opposite ways, 0 when
// one is flat.
std::int64_t agreement(int a, int b, int c, int d) { return dot(normal_of(a, b, c), normal_of(a, c, d)); }

// Whether the lines of a segment ab and of cd in one plane cross strictly within both; where.
bool crossing_of(int a, int b, int c, int d, Rational& at) {
    const Vector along = minus(vector_of(b), vector_of(a));
    const Vector at_c = cross(along, minus(vector_of(c), vector_of(a)));
    const Vector at_d = cross(along, minus(vector_of(d), vector_of(a)));
    if (dot(at_c, at_d) >= 0) return false;
    const Vector other = minus(vector_of(d), vector_of(c));
    if (dot(cross(other, minus(vector_of(a), vector_of(c))),
            cross(other, minus(vector_of(b), vector_of(c)))) >= 0) {
        return false;
    }
    // Both are multiples of one normal, in the ratio of the distances.
    std::size_t k = 0;
    while (at_c[k] == 0) ++k;
    at = between(rational(c), at_c[k], rational(d), at_d[k]);
    return true;
}

void add_edges(const std::vector<int>& ring, std::vector<Piece>& pieces) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        pieces.push_back({rational(ring[i]), rational(ring[(i + 1) % ring.size()])});
    }
}

// What a ring of four corners winds around: two triangles that a diagonal divides it into if both go the same
// way round, else, the ring crossing itself, two triangles with the crossing as a corner.
void add_wound(const std::vector<int>& r, std::vector<Piece>& pieces) {
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        pieces.push_back({rational(r[a]), rational(r[b]), rational(r[c])});
    };
    if (agreement(r[0], r[1], r[2], r[3]) >= 0) {
        triangle(0, 1, 2);
        triangle(0, 2, 3);
        return;
    }
    if (agreement(r[1], r[2], r[3], r[0]) >= 0) {
        triangle(1, 2, 3);
        triangle(1, 3, 0);
        return;
    }
    Rational x = {};
    if (crossing_of(r[0], r[1], r[2], r[3], x)) {
        pieces.push_back({x, rational(r[1]), rational(r[2])});
        pieces.push_back({x, rational(r[3]), rational(r[0])});
    } else if (crossing_of(r[1], r[2], r[3], r[0], x)) {
        pieces.push_back({x, rational(r[2]), rational(r[3])});
        pieces.push_back({x, rational(r[0]), rational(r[1])});
    }
}

// A convex ring less the inner points of a triangle: beyond its first edge; beyond its second and not beyond
// the first; and so on.
void add_around_hole(const std::vector<int>& ring, const std::vector<int>& hole, std::vector<Piece>& pieces) {
    Piece left;
    for (const int i : ring) left.push_back(rational(i));
    const Vector normal = normal_of(hole[0], hole[1], hole[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector a = vector_of(hole[i]);
        const Vector inwards = cross(normal, minus(vector_of(hole[(i + 1) % 3]), a));
        const auto inside = [&](const Rational& p) { return dot(inwards, p.at) - dot(inwards, a) * p.w; };
        Piece beyond;
        clip(
            left, [&](const Rational& p) { return -inside(p); }, beyond);
        pieces.push_back(beyond);
        Piece rest;
        clip(left, inside, rest);
        left = rest;
    }
}

std::vector<Piece> pieces_of(const LatticeFace& face) {
    std::vector<Piece> pieces;
    for (const auto& ring : face.rings) add_edges(ring, pieces);
    const std::vector<int>& outer = face.rings[0];
    if (face.rings.size() > 1) {
        add_around_hole(outer, face.rings[1], pieces);
    } else if (outer.size() == 3) {
        pieces.push_back({rational(outer[0]), rational(outer[1]), rational(outer[2])});
    } else {
        add_wound(outer, pieces);
    }
    return pieces;
}

// A triangle and a segment: the point of the line in the triangle's plane, by Cramer's rule.
int triangle_adds(int i, int j, int k, const Vector& moved_from, int axis, std::int64_t moved_length) {
    constexpr std::int64_t scale = std::int64_t{1} << 30;
    const Vector a = vector_of(i);
    const Vector to_b = minus(vector_of(j), a);
    const Vector to_c = minus(vector_of(k), a);
    Vector along = {0, 0, 0};
    along[static_cast<std::size_t>(axis)] = 1;
    const Vector normal = cross(to_b, to_c);
    const std::int64_t det = dot(normal, along);
    if (det == 0) return 0;
    const std::int64_t sign = det < 0 ? -1 : 1;
    const Vector off = {moved_from[0] - a[0] * scale, moved_from[1] - a[1] * scale,
                        moved_from[2] - a[2] * scale};
    // off + t along = u to_b + v to_c
    const std::int64_t u = sign * dot(cross(off, to_c), along);
    const std::int64_t v = sign * dot(cross(to_b, off), along);
    const std::int64_t t = -sign * dot(normal, off);
    const bool hits = u > 0 && v > 0 && u + v < sign * det * scale && t > 0 && t < sign * det * moved_length;
    return hits ? static_cast<int>(-sign) : 0;
}

bool is_strictly_convex(const std::vector<int>& r) {
    const Vector n = normal_of(r[0], r[1], r[2]);
    for (std::size_t i = 0; i < 4; ++i) {
        if (dot(n, normal_of(r[i], r[(i + 1) % 4], r[(i + 2) % 4])) <= 0) return false;
    }
    return true;
}

// The points of a convex ring's plane that are in the ring, or in it or on it.
std::vector<int> points_in(const std::vector<int>& r, bool touching) {
    std::vector<int> points;
    const Vector n = normal_of(r[0], r[1], r[2]);
    for (int p = 0; p < lattice_points; ++p) {
        if (dot(n, minus(vector_of(p), vector_of(r[0]))) != 0) continue;
        bool in = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::int64_t side = dot(n, normal_of(r[i], r[(i + 1) % 4], p));
            in = in && (touching ? side >= 0 : side > 0);
        }
        if (in) points.push_back(p);
    }
    return points;
}

} // namespace

std::vector<LatticeFace> lattice_triangles() {
    std::vector<LatticeFace> faces;
    for (int a = 0; a < lattice_points; ++a) {
        for (int b = a + 1; b < lattice_points; ++b) {
            for (int c = b + 1; c < lattice_points; ++c) faces.push_back({{{a, b, c}}});
        }
    }
    return faces;
}

std::vector<LatticeFace> lattice_quads() {
    std::vector<LatticeFace> faces;
    for (const LatticeFace& triangle : lattice_triangles()) {
        const std::vector<int>& t = triangle.rings[0];
        const Vector n = normal_of(t[0], t[1], t[2]);
        for (int d = t[2] + 1; d < lattice_points; ++d) {
            if (dot(n, minus(vector_of(d), vector_of(t[0]))) != 0) continue;
            faces.push_back({{{t[0], t[1], t[2], d}}});
            faces.push_back({{{t[0], t[1], d, t[2]}}});
            faces.push_back({{{t[0], d, t[1], t[2]}}});
        }
    }
    return faces;
}

std::vector<LatticeFace> lattice_quads_with_hole(bool touching) {
    std::vector<LatticeFace> faces;
    for (const LatticeFace& quad : lattice_quads()) {
        const std::vector<int>& r = quad.rings[0];
        if (!is_strictly_convex(r)) continue;
        const std::vector<int> points = points_in(r, touching);
        const Vector n = normal_of(r[0], r[1], r[2]);
        for (std::size_t a = 0; a < points.size(); ++a) {
            for (std::size_t b = a + 1; b < points.size(); ++b) {
                for (std::size_t c = b + 1; c < points.size(); ++c) {
                    const std::int64_t way = dot(n, normal_of(points[a], points[b], points[c]));
                    if (way == 0) continue;
                    std::vector<int> hole = {points[a], points[b], points[c]};
                    if (way > 0) std::swap(hole[1], hole[2]);
                    faces.push_back({{r, hole}});
                }
            }
        }
    }
    return faces;
}

std::vector<bool> boxes_met(const LatticeFace& face, const BoxForm& form) {
    std::vector<bool> met(form[0].size() * form[1].size() * form[2].size());
    for (const Piece& piece : pieces_of(face)) mark(piece, form, met);
    return met;
}

int winding_added(const LatticeFace& face, const Halves& from, int axis, int length) {
    constexpr std::int64_t scale = std::int64_t{1} << 30;
    const Vector moved = {from[0] * scale + (std::int64_t{1} << 20),
                          from[1] * scale + (std::int64_t{1} << 10), from[2] * scale + 1};
    int added = 0;
    for (const auto& ring : face.rings) {
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            added += triangle_adds(ring[0], ring[i], ring[i + 1], moved, axis, length * scale);
        }
    }
    return added;
}

} // namespace osem::tests
