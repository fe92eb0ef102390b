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

// What the rows of parts in a row along x have in common: members of any of the 16, and of all.
struct RowsInCommon {
    std::uint32_t any;
    std::uint32_t all;

    RowsInCommon(const std::uint32_t* row, int levels) {
        std::uint64_t any_of_two = 0; // by two rows at a time
        std::uint64_t all_of_two = ~std::uint64_t{0};
        for (int k = 0; k < 4; ++k, row += std::size_t{1} << levels) {
            any_of_two |= two_rows(row) | two_rows(row + 2);
            all_of_two &= two_rows(row) & two_rows(row + 2);
        }
        any = static_cast<std::uint32_t>(any_of_two | any_of_two >> 32);
        all = static_cast<std::uint32_t>(all_of_two & all_of_two >> 32);
    }
};

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

} // namespace

void GridLeaves::set(TreeBuilder& builder) const {
    if (levels <= 2) return set_small(builder);
    sum_up();
    std::uint8_t left[most_grid_levels - 1];   // children that differ in themselves, of the open octants
    std::uint32_t first[most_grid_levels - 1]; // their first leaves
    int height = levels - 2;                   // of the open octant above the parts
    first[height] = 0;
    left[height] = set_uniform(0, height, builder);
    for (;;) {
        if (left[height] == 0) {
            if (++height > levels - 2) return;
            builder.close();
            continue;
        }
        const unsigned child = lowest(left[height]);
        left[height] = without_lowest(left[height]);
        const std::uint32_t leaf = first[height] + (leaf_at(child) << (height + 1));
        if (height == 1) {
            const Leaves part = leaves_of(leaf);
            builder.subtree(child, part.may, part.must);
        } else {
            builder.open(child);
            first[--height] = leaf;
            left[height] = set_uniform(leaf, height, builder);
        }
    }
}

// A leaf is known by its row and its place in it: i + side * row. This is that of child `child` of eight.
std::uint32_t GridLeaves::leaf_at(unsigned child) const {
    return (child & 1U) | (child >> 1 & 1U) << levels | child >> 2 << (2 * levels);
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

std::uint32_t GridLeaves::states_of_parts(std::uint32_t first_row) const {
    const RowsInCommon black(inside + first_row, levels);
    const std::uint32_t any_black = any_of_four(black.any);
    const std::uint32_t all_black = all_of_four(black.all);
    if (met == nullptr) return any_black | all_black << 1;
    const RowsInCommon boundary(met + first_row, levels);
    const std::uint32_t any_boundary = any_of_four(boundary.any);
    return any_black | any_boundary | (all_black & ~any_boundary) << 1 | all_of_four(boundary.all) << 2;
}

// Sets the children of the open octant that are leaves; the other ones.
std::uint8_t GridLeaves::set_uniform(std::uint32_t leaf, int height, TreeBuilder& builder) const {
    const std::uint32_t* states = scratch;
    std::uint32_t rows = std::uint32_t{1} << (levels - 2);
    for (int below = 1; below < height; ++below, rows /= 2) states += std::size_t{rows} * rows;
    const auto place = [this, leaf, height](int axis) { // of the first child, among those of its size
        return (leaf >> (axis * levels) & ((1U << levels) - 1U)) >> (height + 1);
    };
    const std::uint32_t* const row = states + place(axis_y) + std::size_t{rows} * place(axis_z);
    const unsigned x = 4 * place(axis_x);
    const std::uint32_t children = (row[0] >> x & 255U) | (row[1] >> x & 255U) << 8 |
                                   (row[rows] >> x & 255U) << 16 | (row[rows + 1] >> x & 255U) << 24;
    const std::uint8_t black = lowest_of_states(children >> 1);
    const std::uint8_t may = black | lowest_of_states(children >> 2);
    builder.leaves(may, black);
    return static_cast<std::uint8_t>(lowest_of_states(children) & ~may);
}

// The leaves of a part in Morton order, from its first one.
GridLeaves::Leaves GridLeaves::leaves_of(std::uint32_t leaf) const {
    const std::uint32_t row = leaf >> levels;
    const unsigned x = leaf - (row << levels);
    const std::uint64_t black = in_morton_order(as_mask(inside + row, x, levels));
    const std::uint64_t boundary = met == nullptr ? 0 : in_morton_order(as_mask(met + row, x, levels));
    return {black | boundary, black & ~boundary};
}

// A grid of one part, or less.
void GridLeaves::set_small(TreeBuilder& builder) const {
    const Leaves all = leaves_of(0);
    if (levels == 2) return builder.grandchildren(all.may, all.must);
    builder.leaves(static_cast<std::uint8_t>(all.may), static_cast<std::uint8_t>(all.must));
}

} // namespace osem
