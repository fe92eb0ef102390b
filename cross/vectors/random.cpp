#include "random.hpp"

#include <algorithm>

namespace vectors {

using osem::root_side;

namespace {

bool all_in(const osem::Point& p, std::int32_t low) {
    return std::all_of(std::begin(p.at), std::end(p.at),
                       [low](std::int32_t c) { return low <= c && c <= root_side; });
}

} // namespace

std::int32_t Random::coordinate() {
    switch (below(8)) {
    case 0:
        return 0;
    case 1:
        return root_side;
    case 2:
        return below(2) == 0 ? between(0, 2) : between(root_side - 2, root_side);
    case 3:
        return root_side / 2 + between(-1, 1);
    default:
        return between(0, root_side);
    }
}

osem::Point Random::vertex() {
    const std::int32_t x = coordinate();
    const std::int32_t y = coordinate();
    const std::int32_t z = coordinate();
    return {{x, y, z}};
}

osem::Point Random::root_corner() {
    osem::Point p{};
    for (std::int32_t& c : p.at) c = below(2) * root_side;
    return p;
}

osem::Point Random::query() {
    if (below(2) == 0) return vertex();
    osem::Point p = root_corner();
    for (std::int32_t& c : p.at) {
        if (c == 0 && below(2) == 0) c = -1;
    }
    return p;
}

bool is_vertex(const osem::Point& p) { return all_in(p, 0); }
bool is_query(const osem::Point& p) { return all_in(p, -1); }

bool is_extreme(const osem::Point& p) {
    return std::any_of(std::begin(p.at), std::end(p.at),
                       [](std::int32_t c) { return c <= 1 || c >= root_side - 1; });
}

} // namespace vectors
