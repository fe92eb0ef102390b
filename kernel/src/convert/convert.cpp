#include "osem/convert.hpp"

#include "classify/crossing.hpp"
#include "convert/inside.hpp"

namespace osem {

Status Conversion::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                         std::uint32_t scratch_size, NodePool* pool) {
    builder_.abandon();
    const int greatest_depth = options.leaves == LeafRule::centre ? max_depth - 1 : max_depth;
    if (options.depth < 1 || options.depth > greatest_depth) return Status::depth_out_of_range;
    if (scratch_size < convert_scratch(solid.view())) return Status::scratch_too_small;
    solid_ = solid;
    options_ = options;
    list_ = scratch;
    for (std::uint32_t face = 0; face < solid.view().face_count; ++face) list_[face] = face;
    stages_ = StageCounts{};
    visited_ = 0;
    octant_ = root_octant;
    level_ = -1;
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

// The root's reference point is reached from one unit to the left of the root, where the number is 0.
void Conversion::visit_root() {
    started_ = true;
    const std::uint32_t all = solid_.view().face_count;
    const std::int32_t winding = crossings(Point{{-1, 0, 0}}, axis_x, 1, all);
    const std::uint32_t faces = select(root_octant, all);
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
    const std::uint32_t faces = select(octant, frame.faces);
    if (faces != 0 && level_ + 1 < options_.depth) {
        const std::int32_t winding = winding_of_child(frame, child);
        builder_.open(child);
        enter(octant, faces, winding);
        return;
    }
    Colour colour = Colour::boundary;
    if (faces == 0) {
        colour = colour_of(winding_of_child(frame, child));
    } else if (options_.leaves == LeafRule::centre) {
        colour = colour_of(winding_at_centre(octant, faces, winding_of_child(frame, child)));
    }
    builder_.leaf(child, colour);
    leave();
}

void Conversion::enter(const Octant& octant, std::uint32_t faces, std::int32_t winding) {
    octant_ = octant;
    Frame& frame = frames_[++level_];
    frame.faces = faces;
    frame.winding[0] = winding; // child 0 has its parent's reference point
    frame.known = 1;
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

// Brings the faces of the prefix that meet an octant to its front and says how many they are. Whatever walks
// below permute, a prefix keeps its set of faces.
std::uint32_t Conversion::select(const Octant& octant, std::uint32_t faces) {
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < faces; ++i) {
        const std::uint32_t face = list_[i];
        const Decision decision = classify(solid_, face, octant);
        const int stage = static_cast<int>(decision.stage);
        ++(decision.meets ? stages_.accepted : stages_.rejected)[stage];
        if (decision.meets) {
            list_[i] = list_[met];
            list_[met++] = face;
        }
    }
    return met;
}

std::int32_t Conversion::crossings(const Point& from, Axis axis, std::int32_t length,
                                   std::uint32_t faces) const {
    std::int32_t sum = 0;
    for (std::uint32_t i = 0; i < faces; ++i) sum += crossing(solid_.view(), list_[i], from, axis, length);
    return sum;
}

// From child 0 along z, y, x as far as the child's number says. These steps stay inside the open octant, so
// only its own faces can be crossed; each is taken at most once an octant.
std::int32_t Conversion::winding_of_child(Frame& frame, unsigned child) const {
    unsigned at = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const unsigned bit = 1U << axis;
        if ((child & bit) == 0) continue;
        const unsigned next = at | bit;
        if ((frame.known & (1U << next)) == 0) {
            frame.winding[next] =
                frame.winding[at] +
                crossings(octant_.child(at).corner, static_cast<Axis>(axis), octant_.side() / 2, frame.faces);
            frame.known = static_cast<std::uint8_t>(frame.known | (1U << next));
        }
        at = next;
    }
    return frame.winding[child];
}

// The centre is the reference point of the leaf's last child: three steps inside the leaf.
std::int32_t Conversion::winding_at_centre(const Octant& leaf, std::uint32_t faces,
                                           std::int32_t winding) const {
    const std::int32_t half = leaf.side() / 2;
    Point at = leaf.corner;
    for (int axis = 0; axis < 3; ++axis) {
        winding += crossings(at, static_cast<Axis>(axis), half, faces);
        at.at[axis] += half;
    }
    return winding;
}

Colour Conversion::colour_of(std::int32_t winding) const {
    return is_inside(options_.winding, winding) ? Colour::black : Colour::white;
}

TreeOutcome convert(Conversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool) {
    const Status status = job.begin(solid, options, scratch, scratch_size, pool);
    if (status != Status::ok) return {status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}};
    while (job.step(UINT32_MAX)) {
    }
    return job.finish();
}

} // namespace osem
