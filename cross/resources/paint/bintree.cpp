// The bintree technique.
#include "paint/paint.hpp"
#include "sphere.hpp"

namespace osem::cross {

namespace {

constexpr Sphere sphere(Point{{500000, 520000, 540000}}, 300000);
constexpr int depth = 5;
constexpr std::uint32_t block_size = 16384;

Labelling labelling;
std::uint32_t faces[Sphere::triangle_count];
std::uint32_t blocks[block_size];

} // namespace

void paint_bintree() {
    const CheckedSolid solid = CheckedSolid::vouched(sphere.solid());
    const std::uint32_t mark = pool.used();
    Status status = Status::unfinished;
    measured("Labelling::begin", [&] {
        status = labelling.begin(solid, depth, WindingRule::nonzero, faces, Sphere::triangle_count, blocks,
                                 block_size, &pool);
    });
    expect(status == Status::ok);
    measured("Labelling::step", [&] {
        while (labelling.step(1000)) {
        }
    });
    expect(labelling.pairs_visited() != 0);
    measured("Labelling::finish", [&] { status = labelling.finish().built.status; });
    expect(status == Status::ok && pool.used() > mark);
    pool.roll_back(mark);
    measured("convert_by_labelling", [&] {
        const LabellingOutcome outcome =
            convert_by_labelling(labelling, solid, depth, WindingRule::nonzero, faces, Sphere::triangle_count,
                                 blocks, block_size, nullptr);
        use(outcome);
    });
}

} // namespace osem::cross
