#include "support/dense_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "osem/query.hpp"

namespace osem::tests {

const std::vector<Colour> two_colours = {Colour::white, Colour::black};
const std::vector<Colour> three_colours = {Colour::white, Colour::boundary, Colour::black};

Point DenseGrid::corner(std::size_t cell) const {
    Point p = {{0, 0, 0}};
    for (int bit = 0; bit < depth_; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            if (((cell >> (3 * bit + axis)) & 1U) != 0) p.at[axis] += cell_side() << bit;
        }
    }
    return p;
}

Colour DenseGrid::at(const Point& point) const {
    std::size_t index = 0;
    for (int bit = 0; bit < depth_; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto part = static_cast<std::size_t>(point.at[axis] / cell_side() >> bit);
            index |= (part & 1U) << (3 * bit + axis);
        }
    }
    return cells_[index];
}

std::optional<Colour> DenseGrid::uniform_colour(std::size_t first, std::size_t count) const {
    for (std::size_t i = 1; i < count; ++i) {
        if (cells_[first + i] != cells_[first]) return std::nullopt;
    }
    return cells_[first];
}

std::uint64_t DenseGrid::volume(Colour colour) const {
    const auto cells = static_cast<std::uint64_t>(std::count(cells_.begin(), cells_.end(), colour));
    return cells * (root_volume / size());
}

namespace {

// Only the engine's own numbers are used: the standard's distributions differ between libraries.
void fill_blocks(DenseGrid& grid, std::size_t first, std::size_t count, std::mt19937& random,
                 const std::vector<Colour>& palette) {
    const bool is_block = count == 1 || (count < grid.size() && random() % 100 < 30);
    if (!is_block) {
        for (std::size_t k = 0; k < 8; ++k) {
            fill_blocks(grid, first + k * (count / 8), count / 8, random, palette);
        }
        return;
    }
    const Colour colour = palette[random() % palette.size()];
    for (std::size_t i = 0; i < count; ++i) grid[first + i] = colour;
}

// Twice the truth value.
int truth(Colour colour) { return colour == Colour::white ? 0 : colour == Colour::boundary ? 1 : 2; }
Colour colour_of_truth(int twice) {
    return twice == 0 ? Colour::white : twice == 1 ? Colour::boundary : Colour::black;
}

void append_masks(const DenseGrid& grid, std::size_t first, std::size_t count, Masks& masks) {
    const std::size_t at = masks.size();
    masks.emplace_back(std::uint8_t{0}, std::uint8_t{0});
    unsigned may = 0;
    unsigned must = 0;
    for (unsigned k = 0; k < 8; ++k) {
        const std::size_t part = count / 8;
        const std::optional<Colour> colour = grid.uniform_colour(first + k * part, part);
        if (!colour) {
            must |= 1U << k;
            append_masks(grid, first + k * part, part, masks);
            continue;
        }
        if (*colour != Colour::white) may |= 1U << k;
        if (*colour == Colour::black) must |= 1U << k;
    }
    masks[at] = {static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must)};
}

void plant_octant(TreeBuilder& builder, const DenseGrid& grid, std::size_t first, std::size_t count,
                  bool to_the_cells) {
    const std::size_t part = count / 8;
    for (unsigned k = 0; k < 8; ++k) {
        const std::optional<Colour> colour = grid.uniform_colour(first + k * part, part);
        if (colour && (part == 1 || !to_the_cells)) {
            builder.leaf(k, *colour);
        } else {
            builder.open(k);
            plant_octant(builder, grid, first + k * part, part, to_the_cells);
            builder.close();
        }
    }
}

} // namespace

DenseGrid random_grid(int depth, std::uint32_t seed, const std::vector<Colour>& palette) {
    DenseGrid grid(depth);
    std::mt19937 random(seed);
    fill_blocks(grid, 0, grid.size(), random, palette);
    return grid;
}

DenseGrid grid_of(std::uint32_t seed) {
    return random_grid(1 + static_cast<int>(seed % 4), seed, seed % 3 == 0 ? two_colours : three_colours);
}

DenseGrid refined(const DenseGrid& grid, int depth) {
    DenseGrid fine(depth);
    const std::size_t ratio = fine.size() / grid.size();
    for (std::size_t cell = 0; cell < fine.size(); ++cell) fine[cell] = grid[cell / ratio];
    return fine;
}

Colour complement_colour(Colour a) { return colour_of_truth(2 - truth(a)); }

Colour combine_colours(Operator op, Colour a, Colour b) {
    const int x = truth(a);
    const int y = truth(b);
    switch (op) {
    case Operator::unite:
        return colour_of_truth(std::max(x, y));
    case Operator::intersect:
        return colour_of_truth(std::min(x, y));
    case Operator::subtract:
        return colour_of_truth(std::min(x, 2 - y));
    case Operator::exclusive_or:
        return colour_of_truth(std::max(std::min(x, 2 - y), std::min(2 - x, y)));
    }
    return Colour::grey;
}

DenseGrid combined(Operator op, const DenseGrid& a, const DenseGrid& b) {
    const int depth = std::max(a.depth(), b.depth());
    DenseGrid result = refined(a, depth);
    const DenseGrid other = refined(b, depth);
    for (std::size_t cell = 0; cell < result.size(); ++cell) {
        result[cell] = combine_colours(op, result[cell], other[cell]);
    }
    return result;
}

DenseGrid complemented(const DenseGrid& a) {
    DenseGrid result = a;
    for (std::size_t cell = 0; cell < result.size(); ++cell) result[cell] = complement_colour(result[cell]);
    return result;
}

Masks preorder_masks(const DenseGrid& grid) {
    Masks masks;
    append_masks(grid, 0, grid.size(), masks);
    return masks;
}

std::uint64_t expected_digest(const Masks& masks) {
    std::uint64_t hash = 14695981039346656037U;
    for (const auto& [may, must] : masks) {
        for (const std::uint8_t byte : {may, must}) hash = (hash ^ byte) * 1099511628211U;
    }
    return hash;
}

std::uint64_t expected_digest(const DenseGrid& grid) { return expected_digest(preorder_masks(grid)); }

TreeOutcome plant(const DenseGrid& grid, NodePool* pool, bool count_only) {
    TreeBuilder builder;
    builder.begin(pool, count_only);
    plant_octant(builder, grid, 0, grid.size(), false);
    builder.close();
    return builder.finish(grid.depth());
}

TreeOutcome plant_by_cells(const DenseGrid& grid, NodePool* pool) {
    TreeBuilder builder;
    builder.begin(pool);
    plant_octant(builder, grid, 0, grid.size(), true);
    builder.close();
    return builder.finish(grid.depth());
}

Octree planted(const DenseGrid& grid, NodePool& pool) {
    const TreeOutcome outcome = plant(grid, &pool);
    EXPECT_EQ(outcome.status, Status::ok) << describe(outcome.status);
    return outcome.tree;
}

DenseGrid expand(const Octree& tree, int depth) {
    DenseGrid grid(depth);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const PointOutcome found = leaf_at(tree, grid.corner(cell));
        EXPECT_EQ(found.status, Status::ok);
        grid[cell] = found.leaf.colour;
    }
    return grid;
}

} // namespace osem::tests
