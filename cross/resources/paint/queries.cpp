// What is asked of a tree.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

void measure_segments(const Octree& tree) {
    Segment segment = {};
    measured("ray", [&] { segment = ray({{-root_side, 200000, 300000}}, {{1000, 200, 130}}); });
    SegmentWalk walk(tree, segment);
    measured("SegmentWalk::SegmentWalk", [&] {
        const SegmentWalk made(tree, segment);
        use(made);
    });
    Passage passage = {};
    measured("SegmentWalk::next", [&] {
        while (walk.next(passage)) {
        }
    });
    SegmentWalk changes(tree, segment);
    Crossing crossing = {};
    measured("SegmentWalk::next_crossing", [&] {
        while (changes.next_crossing(crossing)) {
        }
    });
    HitOutcome hit = {};
    measured("first_hit", [&] { hit = first_hit(tree, segment); });
    expect(hit.hit);
}

void measure_searches(const Octree& tree) {
    const Octant octant = leaf_at(tree, {{0, 0, 0}}).leaf.octant;
    measured("face_neighbour", [&] {
        const NeighbourOutcome outcome = face_neighbour(tree, octant, {axis_x, true});
        use(outcome);
    });
    measured("NeighbourWalk::NeighbourWalk", [&] {
        const NeighbourWalk made(tree, octant, {axis_x, true});
        use(made);
    });
    NeighbourWalk walk(tree, octant, {axis_x, true});
    Leaf leaf = {};
    measured("NeighbourWalk::next", [&] {
        while (walk.next(leaf)) {
        }
    });
    NearestOutcome nearest = {};
    measured("nearest_leaf", [&] { nearest = nearest_leaf(tree, Point{{0, 0, 0}}); });
    expect(nearest.found);
}

Collision collision;

void measure_collisions(const PaintTrees& trees) {
    measured("Collision::begin", [&] { collision.begin(trees.a, trees.b, {{3, 5, 7}}); });
    measured("Collision::step", [&] {
        while (collision.step(UINT32_MAX)) {
        }
    });
    expect(collision.contact() != Contact::clear);
    measured("collide", [&] {
        const CollisionOutcome outcome = collide(collision, trees.a, trees.b, {{3, 5, 7}});
        use(outcome);
    });
}

} // namespace

void paint_queries(const PaintTrees& trees) {
    measure_segments(trees.a);
    measure_searches(trees.a);
    measure_collisions(trees);
    const Octree& tree = trees.a;
    measured("leaf_at", [&] {
        for (std::int32_t x = 0; x < root_side; x += 10007) {
            const PointOutcome outcome = leaf_at(tree, {{x, x, x}});
            use(outcome);
        }
    });
    measured("colours_in", [&] {
        for (std::int32_t x = 0; x < root_side - 70000; x += 10007) {
            const BoxOutcome outcome = colours_in(tree, {{{x, x, 0}}, {{x + 70000, x + 1, root_side}}});
            use(outcome);
        }
    });
}

} // namespace osem::cross
