// The surface of a tree's solid.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

constexpr std::uint32_t most_corners = 20000;

Boundary job;
BoundaryCorner scratch[most_corners];
Point vertices[most_corners];
std::uint32_t corners[most_corners];
std::uint32_t ring_starts[most_corners];
std::uint32_t face_rings[most_corners];

// Sinks that take everything, and no stack.
bool take_vertex(void*, const Point&) { return true; }
bool take_corner(void*, std::uint32_t) { return true; }
bool take_end(void*) { return true; }

void step_to_the_end() {
    measured("Boundary::step", [] {
        while (job.step(UINT32_MAX)) {
        }
    });
}

} // namespace

void paint_boundary(const PaintTrees& trees) {
    measured("Boundary::begin", [&] { job.begin(trees.a, SolidPart::outer, scratch, most_corners); });
    job.step(100);
    std::uint64_t volume = 0;
    measured("Boundary::walked_volume", [&] { volume = job.walked_volume(); });
    expect(volume != 0 && volume != root_volume);
    step_to_the_end();
    BoundaryOutcome outcome = {};
    measured("Boundary::finish", [&] { outcome = job.finish(); });
    expect(outcome.status == Status::ok && outcome.sizes.faces != 0);
    Status status = Status::unfinished;
    const BoundarySink sink = {take_vertex, take_corner, take_end, take_end, nullptr};
    measured("Boundary::emit", [&] { status = job.emit(sink); });
    expect(status == Status::ok);
    step_to_the_end();
    Solid solid = {};
    measured("boundary_solid", [&] {
        solid = boundary_solid(job, {vertices, corners, ring_starts, face_rings});
    });
    expect(solid.face_count == outcome.sizes.faces && job.finish().status == Status::ok);
}

} // namespace osem::cross
