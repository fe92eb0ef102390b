#include <algorithm>
#include <cmath>

#include "picture/cast.hpp"

namespace osem::host {

namespace {

__extension__ using Wide = __int128;

// Integer vectors: differences of lattice points, their products in 128 bits.
struct Wides {
    Wide x, y, z;
};

Wides wide(const Point& p) { return {p.x(), p.y(), p.z()}; }
Wides operator-(const Wides& a, const Wides& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wides operator+(const Wides& a, const Wides& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Wide dot(const Wides& a, const Wides& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Wides cross(const Wides& a, const Wides& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// An edge seen along the rays. A ray starts at p and has the direction d; `reference` is an axis not parallel
// to d. Coordinates of p and d are below 2^23, so that everything is below 2^(23 + 1 + 45 + 2).
struct Edge {
    Wide from;    ///< place of the ends across d and the reference
    Wide to;      ///< (half-open, so that a chain of edges crosses the plane of a ray once)
    Wides normal; ///< of the plane through the edge along d
    Wide offset;

    Edge(const Wides& a, const Wides& b, const Wides& d, const Wides& across)
        : from(dot(across, a)), to(dot(across, b)), normal(cross(d, b - a)), offset(dot(normal, a)) {}

    // Whether the ray's half-plane to one side crosses the edge.
    bool crossed(const Wides& p, Wide place) const {
        const bool up = to > place;
        if ((from > place) == up) return false;
        return (dot(normal, p) - offset > 0) == up;
    }
};

// A face as the rays see it.
struct Outline {
    std::vector<Edge> edges;
    Wides normal; ///< twice the area vector, below 2^41
    Wides corner; ///< a point of the face's plane
    int low[2] = {0, 0};
    int high[2] = {-1, -1}; ///< the columns and rows that may meet the face
};

// A parameter along a ray, positive. A face in the root has numerator and denominator below 2^63 times 2^0.9,
// so that their products fit.
struct Fraction {
    Wide numerator;
    Wide denominator;
    bool operator<(const Fraction& b) const { return numerator * b.denominator < b.numerator * denominator; }
    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
};

class SolidCaster {
  public:
    SolidCaster(const IntegerSolid& solid, const Camera& camera)
        : solid_(solid), camera_(camera), direction_(wide(camera.direction())), samples_(camera.samples, 0) {
        const Vector& f = camera.forward;
        const bool along_z = std::abs(f[2]) > std::abs(f[0]) && std::abs(f[2]) > std::abs(f[1]);
        across_ = cross(direction_, along_z ? Wides{1, 0, 0} : Wides{0, 0, 1});
    }

    Samples cast(Progress& progress) {
        for (std::uint32_t face = 0; face < solid_.face_count(); ++face) {
            const Outline outline = outline_of(face);
            if (dot(outline.normal, direction_) != 0) cover(face, outline);
            if (face % 256 == 0) progress.show(face, solid_.face_count());
        }
        return std::move(samples_);
    }

  private:
    Wides corner(std::uint32_t index) const { return wide(solid_.vertices[solid_.corners[index]]); }

    Outline outline_of(std::uint32_t face) const {
        Outline outline = {{}, {0, 0, 0}, corner(solid_.ring_starts[solid_.face_rings[face]])};
        double low[2] = {1e9, 1e9};
        double high[2] = {-1e9, -1e9};
        for (std::uint32_t r = solid_.face_rings[face]; r < solid_.face_rings[face + 1]; ++r) {
            const std::uint32_t begin = solid_.ring_starts[r];
            const std::uint32_t end = solid_.ring_starts[r + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const Wides a = corner(i);
                const Wides b = corner(i + 1 < end ? i + 1 : begin);
                outline.edges.emplace_back(a, b, direction_, across_);
                outline.normal = outline.normal + cross(a - outline.corner, b - outline.corner);
                const auto [column, row] = camera_.place_of(solid_.vertices[solid_.corners[i]]);
                low[0] = std::min(low[0], column), high[0] = std::max(high[0], column);
                low[1] = std::min(low[1], row), high[1] = std::max(high[1], row);
            }
        }
        // Rays start on rounded points: those of two units farther may still meet the face.
        const double slack = 1 + std::ldexp(2 / camera_.step, -lattice_bits);
        for (unsigned k = 0; k < 2; ++k) {
            outline.low[k] = static_cast<int>(std::max(0.0, std::floor(low[k] - slack)));
            outline.high[k] = static_cast<int>(std::min(camera_.samples - 1.0, std::ceil(high[k] + slack)));
        }
        return outline;
    }

    void cover(std::uint32_t face, const Outline& outline) {
        const Slope slope = slope_of(outline);
        for (int row = outline.low[1]; row <= outline.high[1]; ++row) {
            for (int column = outline.low[0]; column <= outline.high[0]; ++column) {
                const Wides start = wide(camera_.segment(column, row).from);
                if (inside(outline, start)) meet(face, outline, slope, start, samples_.index(column, row));
            }
        }
    }

    bool inside(const Outline& outline, const Wides& start) const {
        const Wide place = dot(across_, start);
        bool in = false;
        for (const Edge& edge : outline.edges) in ^= edge.crossed(start, place);
        return in;
    }

    Slope slope_of(const Outline& outline) const {
        return camera_.slope_of({static_cast<double>(outline.normal.x), static_cast<double>(outline.normal.y),
                                 static_cast<double>(outline.normal.z)});
    }

    Fraction parameter(const Wides& normal, const Wides& corner, const Wides& start) const {
        const Wide along = dot(normal, direction_);
        const Wide height = dot(normal, corner - start);
        return along > 0 ? Fraction{height, along} : Fraction{-height, -along};
    }

    void meet(std::uint32_t face, const Outline& outline, const Slope& slope, const Wides& start,
              std::size_t i) {
        const Fraction at = parameter(outline.normal, outline.corner, start);
        if (samples_.face[i] != 0 && !(at < nearest_[i])) return;
        if (nearest_.empty()) nearest_.resize(samples_.cells(), Fraction{0, 1});
        nearest_[i] = at;
        samples_.depth[i] = static_cast<float>(at.value() * camera_.ray_length() / camera_.step);
        samples_.slope[i] = slope;
        samples_.face[i] = face + std::uint64_t{1};
        samples_.plane[i] = face;
        samples_.black[i] = 1;
    }

    const IntegerSolid& solid_;
    const Camera& camera_;
    Wides direction_;
    Wides across_;
    Samples samples_;
    std::vector<Fraction> nearest_;
};

} // namespace

Samples cast(const IntegerSolid& solid, const Camera& camera, Progress& progress) {
    return SolidCaster(solid, camera).cast(progress);
}

} // namespace osem::host
