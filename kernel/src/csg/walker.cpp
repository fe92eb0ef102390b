#include "csg/walker.hpp"

#include "convert/inside.hpp"

namespace osem {

Colour CsgSolid::leaf_colour(std::int32_t winding) const {
    return is_inside(winding_, winding) ? Colour::black : Colour::white;
}

Colour CsgSolid::look_at(const Octant& octant, const CsgOptions& options, const Octant& parent,
                         unsigned child) {
    if (octant.level == 0) {
        met_ = faces_.select(octant, faces_.face_count());
        return met_ != 0 ? Colour::grey : leaf_colour(faces_.winding_of_root());
    }
    FaceFrame& frame = frames_[parent.level];
    met_ = faces_.select(octant, frame.faces);
    if (met_ != 0 && octant.level < options.depth) return Colour::grey;
    if (met_ != 0 && options.leaves == LeafRule::conservative) return Colour::boundary;
    const std::int32_t winding = faces_.winding_of_child(frame, parent, child);
    return leaf_colour(met_ == 0 ? winding : faces_.winding_at_centre(octant, met_, winding));
}

void CsgSolid::enter(const Octant& octant, const Octant& parent, unsigned child) {
    const std::int32_t winding = octant.level == 0
                                     ? faces_.winding_of_root()
                                     : faces_.winding_of_child(frames_[parent.level], parent, child);
    frames_[octant.level].open(met_, winding);
}

Status CsgWalker::begin(const CsgOptions& options) const {
    if (CsgSolid* solid = operand_.solid_) {
        if (solid->list_size_ < convert_scratch(solid->solid_.view())) return Status::scratch_too_small;
        solid->faces_.begin(solid->solid_, solid->list_);
        return Status::ok;
    }
    if (const CsgTree* tree = operand_.tree_) {
        return tree->tree_.depth <= options.depth ? Status::ok : Status::depth_out_of_range;
    }
    CsgStream& stream = *operand_.stream_;
    const Status status = stream.cursor_.begin(stream.source_);
    if (status != Status::ok) return status;
    return stream.cursor_.header().depth <= options.depth ? Status::ok : Status::depth_out_of_range;
}

Colour CsgWalker::look_at(const Octant& octant, const CsgOptions& options, const Octant& parent,
                          unsigned child) const {
    if (operand_.solid_ != nullptr) return operand_.solid_->look_at(octant, options, parent, child);
    if (const CsgTree* tree = operand_.tree_) {
        if (octant.level != 0) return tree->path_[parent.level]->colour(child);
        return tree->tree_.top.is_uniform() ? tree->tree_.top.colour(0) : Colour::grey;
    }
    StreamCursor& cursor = operand_.stream_->cursor_;
    OSEM_ASSERT(!cursor.done()); // the walk ends where a stream does, and with its first fault
    const Colour colour = cursor.colour();
    if (colour != Colour::grey) cursor.next();
    return colour;
}

void CsgWalker::enter(const Octant& octant, const Octant& parent, unsigned child) const {
    if (operand_.solid_ != nullptr) {
        operand_.solid_->enter(octant, parent, child);
    } else if (CsgTree* tree = operand_.tree_) {
        tree->path_[octant.level] = octant.level == 0
                                        ? &tree->tree_.top
                                        : &tree->tree_.pool->child(*tree->path_[parent.level], child);
    } else {
        operand_.stream_->cursor_.next();
    }
}

void CsgWalker::leave_out() const {
    if (operand_.stream_ != nullptr) operand_.stream_->cursor_.skip();
}

Status CsgWalker::status(std::uint64_t& offset) const {
    if (operand_.stream_ == nullptr) return Status::ok;
    offset = operand_.stream_->cursor_.offset();
    return operand_.stream_->cursor_.status();
}

} // namespace osem
