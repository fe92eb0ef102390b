#include "picture/ray_walk.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

double last(const Vector& v) { return std::max({v[0], v[1], v[2]}); }
double first(const Vector& v) { return std::min({v[0], v[1], v[2]}); }

} // namespace

RayWalk::RayWalk(const Octree& tree, const Vector& direction) : tree_(tree), inverse_() {
    // A component of 0 is as good as a very small one, and keeps every parameter finite.
    constexpr double least = 1e-12;
    for (unsigned i = 0; i < 3; ++i) {
        if (direction[i] < 0) mirrored_ |= 1U << i;
        inverse_[i] = 1 / std::max(std::abs(direction[i]), least);
    }
}

RayWalk::Frame RayWalk::frame_of(const Node& node, const Vector& enter, const Vector& leave) {
    Frame frame = {node, enter, 0.5 * (enter + leave), leave, 0};
    const double entry = last(enter);
    for (unsigned i = 0; i < 3; ++i) {
        if (frame.middle[i] <= entry) frame.child |= 1U << i;
    }
    return frame;
}

// On to the child behind the plane that the ray reaches first; false when that plane bounds the octant.
bool RayWalk::advance(Frame& frame) {
    unsigned nearest = 0;
    double soonest = 0;
    for (unsigned i = 0; i < 3; ++i) {
        const double plane = frame.upper(i) ? frame.leave[i] : frame.middle[i];
        if (i == 0 || plane < soonest) {
            nearest = i;
            soonest = plane;
        }
    }
    if (frame.upper(nearest)) return false;
    frame.child |= 1U << nearest;
    return true;
}

Hit RayWalk::hit_of(const Frame& frame, Colour colour) const {
    Hit hit = {0, colour, 0};
    for (unsigned i = 0; i < 3; ++i) {
        const double plane = frame.upper(i) ? frame.middle[i] : frame.enter[i];
        if (i == 0 || plane > hit.distance) {
            hit.distance = plane;
            hit.axis = i;
        }
    }
    return hit;
}

bool RayWalk::cast(const Vector& origin, Hit& hit) const {
    Vector enter;
    Vector leave;
    for (unsigned i = 0; i < 3; ++i) {
        const double from = ((mirrored_ >> i) & 1U) != 0 ? 1 - origin[i] : origin[i];
        enter[i] = -from * inverse_[i];
        leave[i] = (1 - from) * inverse_[i];
    }
    if (last(enter) >= first(leave)) return false;

    Frame frames[max_depth];
    int level = 0;
    frames[0] = frame_of(tree_.top, enter, leave);
    while (level >= 0) {
        Frame& frame = frames[level];
        const unsigned child = frame.child ^ mirrored_;
        const Colour colour = frame.node.colour(child);
        if (colour == Colour::grey) {
            Vector from;
            Vector to;
            for (unsigned i = 0; i < 3; ++i) {
                from[i] = frame.upper(i) ? frame.middle[i] : frame.enter[i];
                to[i] = frame.upper(i) ? frame.leave[i] : frame.middle[i];
            }
            frames[++level] = frame_of(tree_.pool->child(frame.node, child), from, to);
            continue;
        }
        if (colour != Colour::white) {
            hit = hit_of(frame, colour);
            return true;
        }
        while (level >= 0 && !advance(frames[level])) --level;
    }
    return false;
}

} // namespace osem::host
