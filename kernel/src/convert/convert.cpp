#include "osem/convert.hpp"

#include "convert/inside.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

Status Conversion::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                         std::uint32_t scratch_size, NodePool* pool) {
    builder_.reset();
    level_ = -1;
    visited_ = 0;
    if (options.depth < 1 || options.depth > greatest_depth(options.leaves)) {
        return Status::depth_out_of_range;
    }
    if (scratch_size < convert_scratch(solid.view())) return Status::scratch_too_small;
    faces_.begin(solid, scratch);
    options_ = options;
    octant_ = root_octant;
    started_ = false;
    builder_.begin(pool);
    return Status::ok;
}

bool Conversion::step(std::uint32_t octants) {
    for (; octants > 0 && builder_.building(); --octants) {
        started_ ? visit_child() : visit_root();
        ++visited_;
    }
    return builder_.building();
}

TreeOutcome Conversion::finish() { return builder_.finish(options_.depth); }

std::uint64_t Conversion::decided_volume() const {
    if (builder_.finished()) return root_volume;
    std::uint64_t decided = 0;
    for (int level = 0; level <= level_; ++level) decided += frames_[level].child * volume_at(level + 1);
    return decided;
}

void Conversion::visit_root() {
    started_ = true;
    const std::int32_t winding = faces_.winding_of_root();
    const std::uint32_t faces = faces_.select(root_octant, faces_.face_count());
    if (faces != 0) {
        enter(root_octant, faces, winding);
        return;
    }
    const Node node = Node::uniform(colour_of(winding));
    builder_.leaves(node.may, node.must);
    builder_.close();
}

void Conversion::visit_child() {
    Frame& frame = frames_[level_];
    const unsigned child = frame.child;
    const Octant octant = octant_.child(child);
    const std::uint32_t faces = faces_.select(octant, frame.faces);
    if (faces != 0 && level_ + 1 < options_.depth) {
        const std::int32_t winding = faces_.winding_of_child(frame, octant_, child);
        builder_.open(child);
        enter(octant, faces, winding);
        return;
    }
    Colour colour = Colour::boundary;
    if (faces == 0) {
        colour = colour_of(faces_.winding_of_child(frame, octant_, child));
    } else if (options_.leaves == LeafRule::centre) {
        const std::int32_t winding = faces_.winding_of_child(frame, octant_, child);
        colour = colour_of(faces_.winding_at_centre(octant, faces, winding));
    }
    builder_.leaf(child, colour);
    leave();
}

void Conversion::enter(const Octant& octant, std::uint32_t faces, std::int32_t winding) {
    octant_ = octant;
    Frame& frame = frames_[++level_];
    frame.open(faces, winding);
    frame.child = 0;
}

// Goes on to the next child, and closes every octant whose last child is done.
void Conversion::leave() {
    while (++frames_[level_].child == 8) {
        builder_.close();
        if (--level_ < 0) return;
        octant_ = octant_.parent();
    }
}

Colour Conversion::colour_of(std::int32_t winding) const {
    return is_inside(options_.winding, winding) ? Colour::black : Colour::white;
}

TreeOutcome convert(Conversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool) {
    const Status status = job.begin(solid, options, scratch, scratch_size, pool);
    if (status != Status::ok) return {status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}};
    run_to_end(job);
    return job.finish();
}

} // namespace osem
