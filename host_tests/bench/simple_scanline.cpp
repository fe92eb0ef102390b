#include "bench/simple_scanline.hpp"

#include <algorithm>
#include <utility>

namespace osem::bench {

namespace {

// An edge as rows see it: 0 or more where a row's line, moved by (e^2, e^3), passes on its left.
struct Edge {
    std::int64_t at; ///< the first row of a layer
    std::int64_t by_y;
    std::int64_t by_z;

    Edge(const Point& a, const Point& b, std::int64_t y, std::int64_t z, int shift) {
        const std::int64_t run = b.y() - a.y();
        const std::int64_t rise = b.z() - a.z();
        const bool has_its_line = rise < 0 || (rise == 0 && run > 0);
        at = run * (z - a.z()) - rise * (y - a.y()) - (has_its_line ? 0 : 1);
        by_y = -rise * (std::int64_t{1} << shift);
        by_z = run * (std::int64_t{1} << shift);
    }
};

std::int64_t normal_x(const Point& a, const Point& b, const Point& c) {
    return std::int64_t{b.y() - a.y()} * (c.z() - a.z()) - std::int64_t{b.z() - a.z()} * (c.y() - a.y());
}

} // namespace

std::uint64_t SimpleScanline::bytes() const {
    return crossings_.capacity() * sizeof crossings_[0] + sorted_.capacity() * sizeof sorted_[0];
}

void SimpleScanline::convert(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles,
                             int depth, RunGrid& result) {
    shift_ = lattice_bits - depth;
    half_ = (root_side >> depth) / 2;
    result.side = 1U << depth;
    result.starts.assign(std::size_t{result.side} * result.side + 1, 0);
    crossings_.clear();
    for (const host::Triangle& t : triangles) {
        const Point &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
        const std::int64_t x = normal_x(a, b, c);
        if (x > 0) cross(a, b, c, x, 1, result.starts.data());
        if (x < 0) cross(a, c, b, -x, 0, result.starts.data());
    }
    sort_into_rows(result);
}

// The rows of a triangle that turns to the left as seen along x, whose normal has so much along it. The sums
// are plane values of corners and centres: under 2^63, as kernel/DESIGN.md has it.
void SimpleScanline::cross(const Point& a, const Point& b, const Point& c, std::int64_t x, unsigned leaves,
                           std::uint32_t* counts) {
    const std::int64_t y =
        std::int64_t{b.z() - a.z()} * (c.x() - a.x()) - std::int64_t{b.x() - a.x()} * (c.z() - a.z());
    const std::int64_t z =
        std::int64_t{b.x() - a.x()} * (c.y() - a.y()) - std::int64_t{b.y() - a.y()} * (c.x() - a.x());
    const auto [low_y, high_y] = std::minmax({a.y(), b.y(), c.y()});
    const auto [low_z, high_z] = std::minmax({a.z(), b.z(), c.z()});
    const std::int64_t first = first_at(low_y), end = first_at(high_y);
    std::int64_t k = first_at(low_z);
    Edge edges[3] = {{a, b, centre(first), centre(k), shift_},
                     {b, c, centre(first), centre(k), shift_},
                     {c, a, centre(first), centre(k), shift_}};
    for (const std::int64_t end_z = first_at(high_z); k < end_z; ++k) {
        std::int64_t ab = edges[0].at, bc = edges[1].at, ca = edges[2].at;
        for (std::int64_t j = first; j < end; ++j) {
            if ((ab | bc | ca) >= 0) {
                const std::int64_t value =
                    x * (a.x() + half_) - y * (centre(j) - a.y()) - z * (centre(k) - a.z()) - 1;
                const auto row = static_cast<std::uint64_t>((k << (lattice_bits - shift_)) + j);
                const auto cell = static_cast<std::uint64_t>(value / (x << shift_)); // rounded up
                ++counts[row];
                crossings_.push_back(row << 32 | 2 * cell | leaves);
            }
            ab += edges[0].by_y, bc += edges[1].by_y, ca += edges[2].by_y;
        }
        for (Edge& edge : edges) edge.at += edge.by_z;
    }
}

// Counts become starts, each row is sorted, and what lies between entering and leaving becomes its runs.
void SimpleScanline::sort_into_rows(RunGrid& result) {
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : result.starts) sum += std::exchange(entry, sum);
    sorted_.resize(crossings_.size());
    for (const std::uint64_t crossing : crossings_) {
        sorted_[result.starts[crossing >> 32]++] = static_cast<std::uint16_t>(crossing);
    }
    result.boundaries.clear();
    auto code = sorted_.begin();
    for (std::uint32_t& start : result.starts) { // until now the row's end
        const auto end = sorted_.begin() + start;
        start = static_cast<std::uint32_t>(result.boundaries.size());
        std::sort(code, end);
        std::uint16_t begin = 0;
        for (std::int32_t winding = 0; code < end; ++code) {
            const auto cell = static_cast<std::uint16_t>(*code / 2);
            if (winding == 0) begin = cell;
            winding += *code % 2 == 0 ? 1 : -1;
            if (winding != 0 || begin == cell) continue;
            result.boundaries.push_back(begin);
            result.boundaries.push_back(cell);
        }
    }
}

} // namespace osem::bench
