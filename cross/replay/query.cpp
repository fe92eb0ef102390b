// Rays, nearest leaves, neighbours and collisions of trees given by their leaves.
#include "osem/collide.hpp"
#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"
#include "osem/ray.hpp"

#include "planted_tree.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

void replay_segment(Reader& reader, Report& report, const Octree& tree) {
    report.begin_case();
    Segment segment = {};
    segment.from = reader.point();
    segment.to = reader.point();
    SegmentWalk walk(tree, segment);
    report.expect("status of a segment", static_cast<int>(Status::ok), static_cast<int>(walk.status()));
    Crossing crossing = {};
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        report.expect("one more crossing", 1, walk.next_crossing(crossing) ? 1 : 0);
        report.expect("numerator", reader.i32(), crossing.at.numerator);
        report.expect("denominator", reader.i32(), crossing.at.denominator);
        report.expect("axis", reader.u8(), crossing.axis);
        report.expect("colour before", reader.u8(), static_cast<int>(crossing.before));
        report.expect("colour after", reader.u8(), static_cast<int>(crossing.after));
    }
    report.expect("no more crossing", 0, walk.next_crossing(crossing) ? 1 : 0);
}

void replay_nearest(Reader& reader, Report& report, const Octree& tree) {
    report.begin_case();
    const Point from = reader.point();
    const NearestOutcome found = nearest_leaf(tree, from, reader.u8());
    const bool expected = reader.u8() != 0;
    const auto distance = static_cast<std::int64_t>(reader.u64());
    const Point cell = reader.point();
    report.expect("whether a leaf is found", expected ? 1 : 0, found.found ? 1 : 0);
    if (!expected || !found.found) return;
    report.expect("squared distance", distance, static_cast<std::int64_t>(found.distance));
    const Octant& octant = found.leaf.octant;
    for (unsigned axis = 0; axis < 3; ++axis) {
        report.expect("nearest leaf", octant.corner.at[axis], cell.at[axis] & -octant.side());
    }
}

Octant read_octant(Reader& reader) {
    const Point corner = reader.point();
    return Octant{corner, reader.u8()};
}

void replay_neighbour(Reader& reader, Report& report, const Octree& tree) {
    report.begin_case();
    const Octant octant = read_octant(reader);
    const auto axis = static_cast<Axis>(reader.u8());
    const bool high = reader.u8() != 0;
    const NeighbourOutcome found = face_neighbour(tree, octant, OctantFace{axis, high});
    report.expect("status of a neighbour", static_cast<int>(Status::ok), static_cast<int>(found.status));
    report.expect("whether it is outside", reader.u8(), found.outside ? 1 : 0);
    const Octant expected = read_octant(reader);
    for (unsigned a = 0; a < 3; ++a) {
        report.expect("corner of a neighbour", expected.corner.at[a], found.octant.corner.at[a]);
    }
    report.expect("level of a neighbour", expected.level, found.octant.level);
    report.expect("colour of a neighbour", reader.u8(), static_cast<int>(found.colour));
}

void replay_collision(Reader& reader, Report& report, Collision& job, const Octree& a, const Octree& b) {
    report.begin_case();
    const Point offset = reader.point();
    const CollisionOutcome found = collide(job, a, b, offset);
    report.expect("status of a collision", static_cast<int>(Status::ok), static_cast<int>(found.status));
    report.expect("contact", reader.u8(), static_cast<int>(found.contact));
}

} // namespace

bool replay_query(Reader& reader, Arena& arena, Report& report) {
    auto* const collision = arena.take<Collision>(1);
    if (collision == nullptr) return false;
    const PlantedTree planted_a(reader, arena);
    if (!planted_a.fits()) return false;
    const PlantedTree planted_b(reader, arena);
    if (!planted_b.fits()) return false;
    const Octree& a = planted_a.tree();
    const Octree& b = planted_b.tree();
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_segment(reader, report, a);
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_nearest(reader, report, a);
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_neighbour(reader, report, a);
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        replay_collision(reader, report, *collision, a, b);
    }
    return true;
}

} // namespace osem::cross
