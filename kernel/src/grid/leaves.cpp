#include "grid/leaves.hpp"

#include "grid/octant_grid.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// The state of an octant that is made up of parts of 4 x 4 x 4 leaves, or of one part, in four bits: whether
// some leaves hold solid or may, all are black, all are boundary. So 0 is white, 3 black, 5 boundary, and:
constexpr std::uint32_t differing = 1;
constexpr std::uint32_t every_state = 0x11111111;

constexpr std::uint32_t any_of_four(std::uint32_t bits) {
    bits |= bits >> 2;
    return (bits | bits >> 1) & every_state;
}
constexpr std::uint32_t all_of_four(std::uint32_t bits) {
    bits &= bits >> 2;
    return bits & bits >> 1 & every_state;
}

constexpr std::uint64_t two_rows(const std::uint32_t* row) { return row[0] | std::uint64_t{row[1]} << 32; }
constexpr std::uint32_t both_or(std::uint64_t rows) { return static_cast<std::uint32_t>(rows | rows >> 32); }
constexpr std::uint32_t both_and(std::uint64_t rows) { return static_cast<std::uint32_t>(rows & rows >> 32); }

// The states of a word as members of a mask, by their lowest bits.
constexpr std::uint8_t lowest_of_states(std::uint32_t states) {
    states &= every_state;
    states |= states >> 3;
    states = (states & 0x03030303U) | (states >> 6 & 0x000c000cU);
    return static_cast<std::uint8_t>((states & 15U) | (states >> 12 & 0xf0U));
}

// The common states of two by two by two octants each, from four rows of them.
constexpr std::uint32_t common_states(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const std::uint32_t across = (a ^ b) | (a ^ c) | (a ^ d);
    const std::uint32_t other = any_of_four(across | across >> 4 | (a ^ a >> 4));
    std::uint32_t states = ((a & ~(15U * other)) | differing * other) & 0x0f0f0f0fU;
    states = (states | states >> 4) & 0x00ff00ffU;
    return (states | states >> 8) & 0xffffU;
}

// Every third bit of a Morton number.
constexpr unsigned coordinate(unsigned morton) {
    return (morton & 1U) | (morton >> 2 & 2U) | (morton >> 4 & 4U);
}

} // namespace

void GridLeaves::set(TreeBuilder& builder) const {
    if (levels <= 2) return set_small(builder);
    sum_up();
    std::uint8_t left[most_grid_levels - 1]; // children that differ in themselves, of the open octants
    int height = levels - 2;                 // of the open octant above the parts
    unsigned octant = 0;                     // in Morton order among those of its height
    left[height] = set_uniform(octant, height, builder);
    for (;;) {
        if (left[height] == 0) {
            if (++height > levels - 2) return;
            builder.close();
            octant >>= 3;
            continue;
        }
        const unsigned child = lowest(left[height]);
        left[height] = without_lowest(left[height]);
        if (height == 1) {
            const Leaves part = leaves_of(8 * octant + child);
            builder.subtree(child, part.may, part.must);
        } else {
            builder.open(child);
            octant = 8 * octant + child;
            --height;
            left[height] = set_uniform(octant, height, builder);
        }
    }
}

// The states of the parts, for a row of them along x one word; and then those of two by two by two parts, and
// so on up to the octants below the grid's own.
void GridLeaves::sum_up() const {
    const std::uint32_t side = std::uint32_t{1} << levels;
    std::uint32_t* state = scratch;
    for (std::uint32_t k = 0; k < side; k += 4) {
        for (std::uint32_t j = 0; j < side; j += 4) *state++ = states_of_parts(j + (k << levels));
    }
    const std::uint32_t* below = scratch;
    for (std::uint32_t rows = side / 4; rows > 2; rows /= 2) {
        for (std::uint32_t k = 0; k < rows; k += 2, below += rows) {
            for (std::uint32_t j = 0; j < rows; j += 2, below += 2) {
                *state++ = common_states(below[0], below[1], below[rows], below[rows + 1]);
            }
        }
    }
}

// By two rows at a time: only what they have in common counts.
std::uint32_t GridLeaves::states_of_parts(std::uint32_t first_row) const {
    std::uint64_t any_may = 0;
    std::uint64_t all_may = ~std::uint64_t{0};
    std::uint64_t any_must = 0;
    std::uint64_t all_must = ~std::uint64_t{0};
    for (std::uint32_t i = 0; i < 16; i += 2) {
        const std::uint32_t row = first_row + (i & 3U) + ((i >> 2) << levels);
        const std::uint64_t black = two_rows(inside + row);
        const std::uint64_t boundary = met == nullptr ? 0 : two_rows(met + row);
        any_may |= black | boundary;
        all_may &= black | boundary;
        any_must |= black & ~boundary;
        all_must &= black & ~boundary;
    }
    return any_of_four(both_or(any_may)) | all_of_four(both_and(all_must)) << 1 |
           (all_of_four(both_and(all_may)) & ~any_of_four(both_or(any_must))) << 2;
}

// Sets the children of the open octant that are leaves; the other ones.
std::uint8_t GridLeaves::set_uniform(unsigned octant, int height, TreeBuilder& builder) const {
    const std::uint32_t* states = scratch;
    std::uint32_t rows = std::uint32_t{1} << (levels - 2);
    for (int below = 1; below < height; ++below, rows /= 2) states += std::size_t{rows} * rows;
    const std::uint32_t* const row =
        states + std::size_t{2} * coordinate(octant >> 1) + std::size_t{2} * rows * coordinate(octant >> 2);
    const unsigned x = 8 * coordinate(octant);
    const std::uint32_t children = (row[0] >> x & 255U) | (row[1] >> x & 255U) << 8 |
                                   (row[rows] >> x & 255U) << 16 | (row[rows + 1] >> x & 255U) << 24;
    const std::uint8_t black = lowest_of_states(children >> 1);
    const std::uint8_t may = black | lowest_of_states(children >> 2);
    builder.leaves(may, black);
    return static_cast<std::uint8_t>(lowest_of_states(children) & ~may);
}

// The leaves of a part in Morton order.
GridLeaves::Leaves GridLeaves::leaves_of(unsigned part) const {
    const unsigned x = 4 * coordinate(part);
    const std::uint32_t first = 4 * coordinate(part >> 1) + ((4 * coordinate(part >> 2)) << levels);
    const std::uint64_t black = in_morton_order(as_mask(inside + first, x, levels));
    const std::uint64_t boundary = met == nullptr ? 0 : in_morton_order(as_mask(met + first, x, levels));
    return {black | boundary, black & ~boundary};
}

// A grid of one part, or less.
void GridLeaves::set_small(TreeBuilder& builder) const {
    const Leaves all = leaves_of(0);
    if (levels == 2) return builder.grandchildren(all.may, all.must);
    builder.leaves(static_cast<std::uint8_t>(all.may), static_cast<std::uint8_t>(all.must));
}

} // namespace osem
