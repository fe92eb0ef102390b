// The surface on its way to the caller.
#include "boundary/corner_order.hpp"
#include "osem/boundary.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

Status Boundary::emit(const BoundarySink& sink) {
    if (phase_ != Phase::ready || (!is_storing() && sizes_.corners != 0)) return Status::unfinished;
    sink_ = sink;
    emission_ = Status::ok;
    walk_.begin(tree_, part_);
    enter(Phase::vertices);
    return Status::ok;
}

bool Boundary::emit_vertices() {
    Octant leaf = root_octant;
    if (emission_ != Status::ok || !walk_.next(leaf)) return false;
    visit_leaf(leaf);
    return true;
}

bool Boundary::emit_face() {
    while (position_ < sizes_.corners && corners_[position_].role != role_outer) ++position_;
    if (position_ == sizes_.corners) return false;
    if (emit_rings(position_++)) return true;
    emission_ = Status::sink_refused;
    return false;
}

bool Boundary::emit_rings(std::uint32_t outer) {
    for (std::uint32_t leader = outer; leader != no_corner; leader = corners_[leader].ring) {
        std::uint32_t corner = leader;
        do {
            if (!sink_.corner(sink_.context, corners_[corner].vertex)) return false;
            corner = corners_[corner].next;
        } while (corner != leader);
        if (!sink_.end_ring(sink_.context)) return false;
    }
    return sink_.end_face(sink_.context);
}

namespace {

// Fills the arrays of a solid.
struct Filler {
    BoundaryArrays arrays;
    Solid solid;
    std::uint32_t rings;

    static Filler& of(void* context) { return *static_cast<Filler*>(context); }
    static bool vertex(void* context, const Point& point) {
        Filler& f = of(context);
        f.arrays.vertices[f.solid.vertex_count++] = point;
        return true;
    }
    static bool corner(void* context, std::uint32_t index) {
        Filler& f = of(context);
        f.arrays.corners[f.solid.corner_count++] = index;
        return true;
    }
    static bool end_ring(void* context) {
        Filler& f = of(context);
        f.arrays.ring_starts[++f.rings] = f.solid.corner_count;
        return true;
    }
    static bool end_face(void* context) {
        Filler& f = of(context);
        f.arrays.face_rings[++f.solid.face_count] = f.rings;
        return true;
    }
};

} // namespace

Solid boundary_solid(Boundary& job, const BoundaryArrays& arrays) {
    arrays.ring_starts[0] = 0;
    arrays.face_rings[0] = 0;
    Filler filler = {
        arrays, Solid{arrays.vertices, 0, arrays.corners, 0, arrays.ring_starts, arrays.face_rings, 0}, 0};
    const Status status =
        job.emit(BoundarySink{Filler::vertex, Filler::corner, Filler::end_ring, Filler::end_face, &filler});
    OSEM_ASSERT(status == Status::ok);
    static_cast<void>(status);
    run_to_end(job);
    return filler.solid;
}

} // namespace osem
