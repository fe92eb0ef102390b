#include "grid/leaves.hpp"

#include "grid/octant_grid.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

std::uint8_t children_of(std::uint64_t set, unsigned child) {
    return static_cast<std::uint8_t>(set >> (8 * child));
}

// States of a part of 4 x 4 x 4 leaves, four bits each: whether some may be black, all are, all are boundary.
constexpr std::uint32_t all_white = 0;
constexpr std::uint32_t differing = 1;
constexpr std::uint32_t all_black = 3;
constexpr std::uint32_t every_part = 0x11111111;

constexpr std::uint32_t any_of_four(std::uint32_t bits) {
    bits |= bits >> 2;
    return (bits | bits >> 1) & every_part;
}
constexpr std::uint32_t all_of_four(std::uint32_t bits) {
    bits &= bits >> 2;
    return bits & bits >> 1 & every_part;
}

// Every third bit of a Morton number.
constexpr unsigned coordinate(unsigned morton) {
    return (morton & 1U) | (morton >> 2 & 2U) | (morton >> 4 & 4U);
}

Colour colour_of(std::uint32_t state) {
    return state == all_white ? Colour::white : state == all_black ? Colour::black : Colour::boundary;
}

} // namespace

void set_leaves(TreeBuilder& builder, std::uint64_t may, std::uint64_t must, std::uint64_t open) {
    std::uint32_t uniform_may = 0; // the children that are leaves, as one node
    std::uint32_t uniform_must = 0;
    std::uint32_t mixed_children = 0;
    for (unsigned child = 0; child < 8; ++child) {
        const unsigned some = children_of(may, child);
        const unsigned all = children_of(must, child);
        if ((some == 0 || some == 255) && (all == 0 || all == 255)) {
            uniform_may |= (some & 1U) << child;
            uniform_must |= (all & 1U) << child;
        } else {
            mixed_children |= 1U << child;
        }
    }
    builder.leaves(static_cast<std::uint8_t>(uniform_may), static_cast<std::uint8_t>(uniform_must));
    for (unsigned child = 0; child < 8; ++child) {
        if (!contains(mixed_children, child) || children_of(open, child) != 0) continue;
        builder.graft(child, Node::of(children_of(may, child), children_of(must, child), 0));
    }
}

void GridLeaves::set(TreeBuilder& builder) const {
    if (levels == 1) {
        std::uint32_t some = 0;
        std::uint32_t all = 0;
        for (std::uint32_t row = 0; row < 4; ++row) {
            some |= (may(row) & 3U) << (2 * row);
            all |= (must(row) & 3U) << (2 * row);
        }
        return builder.leaves(static_cast<std::uint8_t>(some), static_cast<std::uint8_t>(all));
    }
    if (levels == 2) return set_part(0, builder);
    sum_up();
    // Parts in Morton order; octants that are all alike are passed over at once.
    const int top = levels - 2;
    const unsigned end = 1U << (3 * top);
    int height = top; // of the open octant above the parts
    for (unsigned part = 0; part < end;) {
        const unsigned child = part >> (3 * --height) & 7U;
        const std::uint32_t state = common_state(part, height);
        if (state == differing) {
            builder.open(child);
            if (height > 0) continue;
            set_part(part, builder);
            builder.close();
        } else {
            builder.leaf(child, colour_of(state));
        }
        part += 1U << (3 * height);
        for (++height; height < top && (part & ((1U << (3 * height)) - 1)) == 0; ++height) builder.close();
    }
}

// The states of the parts, for a row of them along x one word.
void GridLeaves::sum_up() const {
    const std::uint32_t side = std::uint32_t{1} << levels;
    std::uint32_t* state = scratch;
    for (std::uint32_t k = 0; k < side; k += 4) {
        for (std::uint32_t j = 0; j < side; j += 4) {
            std::uint32_t any_may = 0;
            std::uint32_t all_may = ~std::uint32_t{0};
            std::uint32_t any_must = 0;
            std::uint32_t all_must = ~std::uint32_t{0};
            for (std::uint32_t i = 0; i < 16; ++i) {
                const std::uint32_t row = j + (i & 3U) + ((k + (i >> 2)) << levels);
                any_may |= may(row);
                all_may &= may(row);
                any_must |= must(row);
                all_must &= must(row);
            }
            *state++ = any_of_four(any_may) | all_of_four(all_must) << 1 |
                       (all_of_four(all_may) & ~any_of_four(any_must)) << 2;
        }
    }
}

// The state of an octant `height` levels above the parts, the first of which is given.
std::uint32_t GridLeaves::common_state(unsigned part, int height) const {
    const unsigned x = coordinate(part);
    const unsigned y = coordinate(part >> 1);
    const unsigned z = coordinate(part >> 2);
    const unsigned side = 1U << height;
    const std::uint32_t* row = scratch + y + (z << (levels - 2));
    const std::uint32_t mask = ~std::uint32_t{0} >> ((32 - 4 * side) & 31U);
    const std::uint32_t first = row[0] >> (4 * x) & 15U;
    if (first == differing) return differing;
    for (unsigned k = 0; k < side; ++k, row += std::uint32_t{1} << (levels - 2)) {
        for (unsigned j = 0; j < side; ++j) {
            if ((row[j] >> (4 * x) & mask) != (first * every_part & mask)) return differing;
        }
    }
    return first;
}

namespace {

// The octants of a part, the first of which is given, in Morton order. Of a row its two lower bits are of one
// child of the part, the two upper ones of the next.
std::uint64_t part_of(const std::uint32_t* row, unsigned x, int levels) {
    std::uint64_t set = 0;
    for (unsigned k = 0; k < 4; ++k, row += std::size_t{1} << levels) {
        for (unsigned j = 0; j < 4; ++j) {
            const std::uint32_t bits = row[j] >> x;
            const unsigned place = (j & 1U) * 2 + (j & 2U) * 8 + (k & 1U) * 4 + (k & 2U) * 16;
            set |= std::uint64_t{(bits & 3U) | (bits & 12U) << 6} << place;
        }
    }
    return set;
}

} // namespace

void GridLeaves::set_part(unsigned part, TreeBuilder& builder) const {
    const unsigned x = 4 * coordinate(part);
    const std::uint32_t first = 4 * coordinate(part >> 1) + ((4 * coordinate(part >> 2)) << levels);
    const std::uint64_t black = part_of(inside + first, x, levels);
    const std::uint64_t boundary = met == nullptr ? 0 : part_of(met + first, x, levels);
    set_leaves(builder, black | boundary, black & ~boundary);
}

} // namespace osem
