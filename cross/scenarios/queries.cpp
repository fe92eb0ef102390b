// Scenarios of what is asked of a tree.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

Octree plate_tree() {
    ConvertOptions options;
    options.depth = 4;
    return converted(plate(), options).tree;
}

Point any_cell(Random& random) {
    const std::int32_t x = random.below(root_side);
    const std::int32_t y = random.below(root_side);
    const std::int32_t z = random.below(root_side);
    return Point{{x, y, z}};
}

void add(Digest& digest, const Leaf& leaf) {
    for (const std::int32_t coordinate : leaf.octant.corner.at) digest.add(coordinate);
    digest.add(leaf.octant.level);
    digest.add(leaf.colour);
}

} // namespace

std::uint64_t point_queries() {
    Digest digest;
    const Octree tree = plate_tree();
    Random random(21);
    for (int i = 0; i < 1000; ++i) {
        Point cell = any_cell(random);
        if (i % 50 == 0) cell.at[i % 3] = i % 100 == 0 ? -1 : root_side;
        const PointOutcome outcome = leaf_at(tree, cell);
        digest.add(outcome.status);
        if (outcome.status != Status::ok) continue;
        add(digest, outcome.leaf);
        digest.add(outcome.visited);
    }
    return digest.value();
}

// Boxes of all sizes, many of them with a side in a plane of leaves.
std::uint64_t box_queries() {
    Digest digest;
    const Octree tree = plate_tree();
    Random random(22);
    for (int i = 0; i < 1000; ++i) {
        // Near a leaf of the tree: inside it, up to its faces, a cell short of them, or past them.
        const Octant leaf = leaf_at(tree, any_cell(random)).leaf.octant;
        CellBox box = {leaf.corner, leaf.corner};
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t side = leaf.side();
            box.low.at[axis] += random.below(3) * side / 4 - (random.below(8) == 0 ? side : 0);
            box.high.at[axis] +=
                side + random.below(3) - 1 + (random.below(4) == 0 ? side * random.below(4) : 0);
            if (i % 16 == 0) continue; // as it comes: empty or off the root
            if (box.low.at[axis] < 0) box.low.at[axis] = 0;
            if (box.high.at[axis] > root_side) box.high.at[axis] = root_side;
        }
        const BoxOutcome outcome = colours_in(tree, box);
        digest.add(outcome.status);
        digest.add(outcome.colours);
        digest.add(outcome.touches);
        digest.add(outcome.visited);
    }
    return digest.value();
}

std::uint64_t measures_and_leaves() {
    Digest digest;
    const Octree tree = plate_tree();
    const Measures m = measure(tree);
    for (const std::uint64_t number :
         {m.nodes, m.white_leaves, m.black_leaves, m.boundary_leaves, m.inner_volume, m.outer_volume}) {
        digest.add(number);
    }
    LeafWalk walk(tree);
    for (Leaf leaf = {}; walk.next(leaf);) add(digest, leaf);
    const Octree again = plate_tree(); // the same leaves in other nodes
    digest.add(same_leaves(tree, again));
    digest.add(same_leaves(tree, complement(fresh<Combination>(), again, pool).tree));
    return digest.value();
}

namespace {

// Ends in the root, in its faces and outside; some segments run along leaves' faces, edges or diagonals.
Segment any_segment(Random& random, std::int32_t step) {
    Segment segment = {};
    for (int axis = 0; axis < 3; ++axis) {
        segment.from.at[axis] = (random.below(48) - 16) * step;
        segment.to.at[axis] = (random.below(48) - 16) * step;
        if (random.below(4) == 0) segment.to.at[axis] = segment.from.at[axis];
    }
    return segment;
}

void add(Digest& digest, const Parameter& parameter) {
    digest.add(parameter.numerator);
    digest.add(parameter.denominator);
}

} // namespace

std::uint64_t segment_walks() {
    Digest digest;
    const Octree tree = plate_tree();
    Random random(23);
    for (int i = 0; i < 400; ++i) {
        const Segment segment = any_segment(random, i % 2 == 0 ? root_side / 16 : 65521);
        auto& walk = fresh<SegmentWalk>(tree, segment);
        for (Passage passage = {}; walk.next(passage);) {
            add(digest, passage.leaf);
            add(digest, passage.entry);
            add(digest, passage.exit);
        }
        digest.add(walk.visited());
        auto& changes = fresh<SegmentWalk>(tree, ray(segment.from, segment.to));
        for (Crossing crossing = {}; changes.next_crossing(crossing);) {
            add(digest, crossing.at);
            digest.add(crossing.axis);
            digest.add(crossing.after);
        }
        const HitOutcome hit = first_hit(tree, segment, colour_bit(Colour::black));
        digest.add(hit.hit);
        digest.add(hit.visited);
    }
    return digest.value();
}

std::uint64_t neighbours_and_nearest_leaves() {
    Digest digest;
    const Octree tree = plate_tree();
    Random random(24);
    for (int i = 0; i < 300; ++i) {
        const Octant octant = leaf_at(tree, any_cell(random)).leaf.octant;
        const OctantFace face = {static_cast<Axis>(random.below(3)), random.below(2) != 0};
        const NeighbourOutcome neighbour = face_neighbour(tree, octant, face);
        add(digest, Leaf{neighbour.octant, neighbour.colour});
        digest.add(neighbour.visited);
        NeighbourWalk walk(tree, octant, face);
        for (Leaf leaf = {}; walk.next(leaf);) add(digest, leaf);
        const Point from = any_segment(random, 65521).from;
        const auto colours = static_cast<std::uint8_t>(random.below(16));
        const NearestOutcome nearest =
            nearest_leaf(tree, from, colours, i % 2 == 0 ? UINT64_MAX : 1ULL << 36);
        digest.add(nearest.found);
        digest.add(nearest.distance);
        digest.add(nearest.visited);
        if (nearest.found) add(digest, nearest.leaf);
    }
    return digest.value();
}

std::uint64_t collisions() {
    Digest digest;
    const Octree tree = plate_tree();
    auto& job = fresh<Collision>();
    Random random(25);
    for (int i = 0; i < 60; ++i) {
        const Point offset = any_segment(random, i % 2 == 0 ? root_side / 16 : 65521).from;
        job.begin(tree, tree, offset);
        while (job.step(7)) {
        }
        const CollisionOutcome found = job.finish();
        digest.add(found.contact);
        digest.add(found.visited);
        add(digest, found.a);
        add(digest, found.b);
    }
    return digest.value();
}

} // namespace osem::cross
