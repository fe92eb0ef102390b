#include "grid/leaves.hpp"

#include "grid/four.hpp"
#include "grid/octant_grid.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// Cubes of 8 x 8 x 8 leaves, those in a row along x side by side in a byte each: its lowest bits say whether
// some leaves are black or boundary, all are black, all are boundary.
constexpr std::uint32_t lowest_of_each = 0x01010101;

constexpr std::uint32_t any_of_eight(std::uint32_t bits) {
    bits |= bits >> 4;
    bits |= bits >> 2;
    return (bits | bits >> 1) & lowest_of_each;
}
constexpr std::uint32_t all_of_eight(std::uint32_t bits) {
    bits &= bits >> 4;
    bits &= bits >> 2;
    return bits & bits >> 1 & lowest_of_each;
}

// What the rows of such cubes have in common: members of any of the 64, and of all.
struct RowsInCommon {
    std::uint32_t any;
    std::uint32_t all;

    RowsInCommon(const std::uint32_t* row, int levels) {
        Four any_of_four = {};
        Four all_of_four = ~any_of_four;
        for (std::size_t layer = 0; layer < 8; ++layer) {
            for (std::size_t j = layer << levels, end = j + 8; j < end; j += 4) {
                const Four rows = {row[j], row[j + 1], row[j + 2], row[j + 3]};
                any_of_four |= rows;
                all_of_four &= rows;
            }
        }
        any = any_of_four[0] | any_of_four[1] | any_of_four[2] | any_of_four[3];
        all = all_of_four[0] & all_of_four[1] & all_of_four[2] & all_of_four[3];
    }
};

} // namespace

void GridLeaves::set(TreeBuilder& builder) const {
    if (levels <= 2) return set_small(builder);
    if (levels == 3) {
        Cube all;
        read(all, 0, 0);
        const Parts& may = may_of(all);
        for (unsigned child = 0; child < 8; ++child) builder.subtree(child, may[child], all.must[child]);
        return;
    }
    note_states();
    if (levels == 4) return set_eight_cubes(0, builder);
    for (unsigned octant = 0; octant < 8; ++octant) {
        builder.open(octant);
        set_eight_cubes(octant, builder);
        builder.close();
    }
}

void GridLeaves::note_states() const {
    const std::uint32_t side = std::uint32_t{1} << levels;
    std::uint32_t* states = scratch;
    for (std::uint32_t k = 0; k < side; k += 8) {
        for (std::uint32_t j = 0; j < side; j += 8) *states++ = states_of_cubes(j + (k << levels));
    }
}

std::uint32_t GridLeaves::states_of_cubes(std::uint32_t first_row) const {
    const RowsInCommon black(inside + first_row, levels);
    const std::uint32_t any_black = any_of_eight(black.any);
    const std::uint32_t all_black = all_of_eight(black.all);
    if (met == nullptr) return any_black | all_black << 1;
    const RowsInCommon boundary(met + first_row, levels);
    const std::uint32_t any_boundary = any_of_eight(boundary.any);
    return any_black | any_boundary | (all_black & ~any_boundary) << 1 | all_of_eight(boundary.all) << 2;
}

// Sets the children of the open octant, which is child `octant` of the grid's, or the grid's own: cubes.
void GridLeaves::set_eight_cubes(unsigned octant, TreeBuilder& builder) const {
    const unsigned x = (octant & 1U) * 16;
    const unsigned j = (octant >> 1 & 1U) * 2; // of its first cube
    const unsigned k = (octant >> 2) * 2;
    const std::size_t cubes = std::size_t{1} << (levels - 3); // along an axis
    const std::uint32_t* const states = scratch + j + k * cubes;
    const auto two = [states, x](std::size_t row) { return std::uint64_t{states[row] >> x & 0xffffU}; };
    const std::uint64_t all = two(0) | two(1) << 16 | two(cubes) << 32 | two(cubes + 1) << 48;
    const std::uint8_t black = lowest_of_bytes(all >> 1);
    const std::uint8_t may = black | lowest_of_bytes(all >> 2);
    builder.leaves(may, black);
    auto left = static_cast<std::uint8_t>(lowest_of_bytes(all) & ~may);
    for (; left != 0; left = without_lowest(left)) {
        const unsigned child = lowest(left);
        const unsigned row = 8 * (j + (child >> 1 & 1U)) + (8 * (k + (child >> 2)) << levels);
        Cube cube;
        read(cube, row, x + 8 * (child & 1U));
        builder.subtree_of_512(child, may_of(cube), cube.must);
    }
}

// A cube's leaves from its first row on, which it has from x on.
void GridLeaves::read(Cube& cube, std::uint32_t row, unsigned x) const {
    eight_in_morton_order(inside + row, x, levels, cube.must);
    if (met == nullptr) return;
    eight_in_morton_order(met + row, x, levels, cube.may);
    for (unsigned part = 0; part < 8; ++part) {
        const std::uint64_t boundary = cube.may[part];
        cube.may[part] |= cube.must[part];
        cube.must[part] &= ~boundary;
    }
}

// A grid of 4 x 4 x 4 leaves, or less.
void GridLeaves::set_small(TreeBuilder& builder) const {
    const std::uint64_t black = in_morton_order(as_mask(inside, levels));
    const std::uint64_t boundary = met == nullptr ? 0 : in_morton_order(as_mask(met, levels));
    const std::uint64_t may = black | boundary;
    const std::uint64_t must = black & ~boundary;
    if (levels == 2) return builder.grandchildren(may, must);
    builder.leaves(static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must));
}

} // namespace osem
