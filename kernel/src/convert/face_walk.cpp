#include "osem/face_walk.hpp"

#include "classify/box.hpp"
#include "classify/crossing.hpp"

namespace osem {

void FaceWalk::begin(const CheckedSolid& solid, std::uint32_t* list) {
    solid_ = solid;
    list_ = list;
    for (std::uint32_t face = 0; face < solid.view().face_count; ++face) list_[face] = face;
    stages_ = StageCounts{};
}

std::uint32_t FaceWalk::select(const Octant& octant, std::uint32_t faces) {
    return select_faces(solid_.view(), box_of(octant), list_, faces, stages_);
}

std::int32_t FaceWalk::crossings(const Point& from, Axis axis, std::int32_t length,
                                 std::uint32_t faces) const {
    std::int32_t sum = 0;
    for (std::uint32_t i = 0; i < faces; ++i) sum += crossing(solid_.view(), list_[i], from, axis, length);
    return sum;
}

std::int32_t FaceWalk::winding_of_root() const {
    return crossings(Point{{-1, 0, 0}}, axis_x, 1, solid_.view().face_count);
}

std::int32_t FaceWalk::winding_of_child(FaceFrame& frame, const Octant& octant, unsigned child) const {
    unsigned at = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const unsigned bit = 1U << axis;
        if ((child & bit) == 0) continue;
        const unsigned next = at | bit;
        if ((frame.known & (1U << next)) == 0) {
            frame.winding[next] =
                frame.winding[at] +
                crossings(octant.child(at).corner, static_cast<Axis>(axis), octant.side() / 2, frame.faces);
            frame.known = static_cast<std::uint8_t>(frame.known | (1U << next));
        }
        at = next;
    }
    return frame.winding[child];
}

std::int32_t FaceWalk::winding_at_centre(const Octant& leaf, std::uint32_t faces,
                                         std::int32_t winding) const {
    FaceFrame frame;
    frame.open(faces, winding);
    return winding_of_child(frame, leaf, 7);
}

} // namespace osem
