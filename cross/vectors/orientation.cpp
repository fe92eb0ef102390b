// Points beside, on and at the ends of lines.
#include <numeric>

#include "exact.hpp"
#include "random.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

constexpr int lines = 12000;
constexpr int queries = 10;

// The other end: anywhere, the same point, or along an axis.
osem::Point other_end(Random& random, const osem::Point& a) {
    osem::Point b = random.below(4) == 0 ? random.root_corner() : random.vertex();
    if (random.below(16) == 0) b = a;
    if (random.below(8) == 0) b.at[random.below(3)] = a.at[random.below(3)];
    return b;
}

// A lattice point of the line a b.
osem::Point on_line(Random& random, const osem::Point& a, const osem::Point& b) {
    std::int32_t steps = 0;
    for (int axis = 0; axis < 3; ++axis) steps = std::gcd(steps, b.at[axis] - a.at[axis]);
    const std::int32_t k = steps == 0 ? 0 : random.between(0, steps);
    osem::Point q = a;
    for (int axis = 0; axis < 3 && steps != 0; ++axis) q.at[axis] += k * ((b.at[axis] - a.at[axis]) / steps);
    return q;
}

osem::Point query(Random& random, const osem::Point& a, const osem::Point& b) {
    osem::Point q = random.query();
    switch (random.below(8)) {
    case 0:
        return random.below(2) == 0 ? a : b;
    case 1:
        return on_line(random, a, b);
    case 2:
    case 3:
        q = on_line(random, a, b);
        q.at[random.below(3)] += random.between(-1, 1);
        break;
    case 4: {
        const int axis = random.below(3);
        q.at[axis] = a.at[axis];
        break;
    }
    default:
        break;
    }
    return is_query(q) ? q : a;
}

} // namespace

void write_orientation(const std::string& folder) {
    VectorFile file(osem::cross::Topic::orientation);
    Random random(11);
    for (int line = 0; line < lines; ++line) {
        const osem::Point a = random.below(4) == 0 ? random.root_corner() : random.vertex();
        const osem::Point b = other_end(random, a);
        Bytes body;
        body.point(a);
        body.point(b);
        for (int i = 0; i < queries; ++i) {
            const osem::Point q = query(random, a, b);
            body.point(q);
            bool degenerate = false;
            for (int axis = 0; axis < 3; ++axis) {
                const std::int64_t value = area_along_axis(axis, a, b, q);
                degenerate = degenerate || value == 0;
                body.i64(value);
            }
            for (const auto& diagonal : osem::cross::diagonals) {
                const std::int64_t value = area_along_diagonal(diagonal[0], diagonal[1], a, b, q);
                degenerate = degenerate || value == 0;
                body.i64(value);
            }
            file.tally().count(degenerate, is_extreme(a) || is_extreme(b) || is_extreme(q));
        }
        file.add_record(std::move(body));
    }
    file.write(folder);
}

} // namespace vectors
