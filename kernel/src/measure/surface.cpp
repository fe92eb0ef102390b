#include "osem/measure.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

// Takes in a piece; `solid` are those of its slots that are in the solid. Every visit changes a number by one
// piece at most, so the characteristics are 2^63 visits away from overflow.
void add_piece(SurfaceMeasures& m, const Cluster& piece, unsigned solid) {
    if (solid == 0) return;
    const unsigned flat = count_bits(piece.axes);
    const std::int64_t sign = flat % 2 == 0 ? -1 : 1; // (-1)^dimension, which is 3 - flat
    m.euler_closed += sign;
    if (solid == piece.slots) {
        m.euler_open -= sign;
    } else if (flat == 1) {
        const auto side = static_cast<std::uint64_t>(root_side >> piece.level);
        m.area[piece.axes / 2] += side * side;
    }
}

} // namespace

void SurfaceMeasurement::begin(const Octree& tree) {
    walk_.begin(tree, 3, true, LeafBlocks{nullptr, 0});
    inner_ = {};
    outer_ = {};
    done_ = false;
}

bool SurfaceMeasurement::step(std::uint32_t clusters) {
    while (walk_.ahead()) {
        if (clusters == 0) return true;
        --clusters;
        if (!walk_.visit()) continue;
        const Cluster piece = walk_.cluster();
        add_piece(inner_, piece, piece.may & piece.must);
        add_piece(outer_, piece, piece.may);
    }
    done_ = walk_.visited() > 0;
    return false;
}

SurfaceOutcome SurfaceMeasurement::finish() const {
    return SurfaceOutcome{done_ ? Status::ok : Status::unfinished, inner_, outer_};
}

SurfaceOutcome measure_surface(SurfaceMeasurement& job, const Octree& tree) {
    job.begin(tree);
    run_to_end(job);
    return job.finish();
}

} // namespace osem
