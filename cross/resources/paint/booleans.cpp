// Booleans in a pool.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

Combination combination;

} // namespace

void paint_booleans(const PaintTrees& trees) {
    const Octree& a = trees.a;
    const Octree& b = trees.b;
    constexpr Operator operators[] = {Operator::unite, Operator::intersect, Operator::subtract};
    measured("combine", [&] {
        for (const Operator op : operators) {
            const TreeOutcome outcome = combine(combination, op, a, b, pool);
            use(outcome);
        }
    });
    measured("complement", [&] {
        const TreeOutcome outcome = complement(combination, a, pool);
        use(outcome);
    });
    measured("Combination::begin", [&] {
        use(combination.begin(Operator::unite, a, a, pool));
        use(combination.begin(Operator::exclusive_or, a, b, pool));
    });
    measured("Combination::step", [&] { combination.step(50); });
    std::uint64_t volume = 0;
    measured("Combination::decided_volume", [&] { volume = combination.decided_volume(); });
    expect(volume != 0);
    measured("Combination::step", [&] {
        while (combination.step(1000)) {
        }
    });
    measured("Combination::finish", [&] {
        const TreeOutcome outcome = combination.finish();
        use(outcome);
    });
}

} // namespace osem::cross
