// Scenarios of Boolean operators and compaction.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

constexpr Operator operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                  Operator::exclusive_or};

// All operators both ways, each result given back at once.
void add_combinations(Digest& digest, const Octree& a, const Octree& b) {
    const std::uint32_t mark = pool.used();
    auto& combination = fresh<Combination>();
    for (const Operator op : operators) {
        add(digest, combine(combination, op, a, b, pool));
        digest.add(combination.nodes_visited());
        pool.roll_back(mark);
        add(digest, combine(combination, op, b, a, pool));
        pool.roll_back(mark);
    }
    add(digest, complement(combination, a, pool));
    pool.roll_back(mark);
}

std::uint64_t booleans(LeafRule leaves) {
    Digest digest;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        pool.roll_back(0);
        ConvertOptions options;
        options.leaves = leaves;
        options.depth = 4;
        const TreeOutcome a = converted(seed % 2 == 0 ? octahedron() : plate(), options);
        options.depth = seed % 3 == 0 ? 3 : 4;
        const TreeOutcome b = converted(tetrahedra(200 + seed, Point{{0, 0, 0}}, root_side), options);
        add(digest, a);
        add(digest, b);
        if (a.status == Status::ok && b.status == Status::ok) add_combinations(digest, a.tree, b.tree);
    }
    return digest.value();
}

} // namespace

std::uint64_t booleans_conservative() { return booleans(LeafRule::conservative); }

std::uint64_t booleans_centre() { return booleans(LeafRule::centre); }

// Operands that are the same tree, parts of one another, or of one colour.
std::uint64_t shared_operands() {
    Digest digest;
    ConvertOptions options;
    options.depth = 4;
    options.leaves = LeafRule::centre;
    const Octree a = converted(octahedron(), options).tree;
    options.depth = 3;
    const Octree b = converted(plate(), options).tree;
    const Octree both = combine(fresh<Combination>(), Operator::intersect, a, b, pool).tree;
    add_combinations(digest, a, a);
    add_combinations(digest, a, both);
    add_combinations(digest, b, both);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        add_combinations(digest, b, Octree::uniform(pool, colour));
    }
    return digest.value();
}

std::uint64_t compaction() {
    Digest digest;
    ConvertOptions options;
    options.depth = 4;
    converted(octahedron(), options); // nobody keeps it
    options.depth = 3;
    const Octree a = converted(plate(), options).tree;
    const Octree b = converted(tetrahedra(300, Point{{0, 0, 0}}, root_side), options).tree;
    Octree kept[] = {combine(fresh<Combination>(), Operator::unite, a, b, pool).tree, a};
    std::uint32_t marks[compact_scratch(pool_capacity)];
    digest.add(pool.used());
    digest.add(compact(pool, kept, 2, marks, compact_scratch(pool_capacity)));
    digest.add(pool.used());
    for (const Octree& tree : kept) digest.add(osem::digest(tree));
    for (std::uint32_t i = 0; i < pool.used(); ++i) { // where every node has come to lie
        const Node& node = pool.at(static_cast<NodeIndex>(i));
        digest.add(node.may);
        digest.add(node.must);
        digest.add(std::uint32_t{node.first()});
    }
    return digest.value();
}

} // namespace osem::cross
