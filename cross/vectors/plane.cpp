// Points on and beside the planes of faces.
#include "exact.hpp"
#include "face_case.hpp"
#include "random.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

constexpr unsigned faces = 12000;
constexpr int queries = 10;

// Corners a + k d for whole k, the first three or more of them on one line, then perhaps one off it.
oracle::Polygon slow_to_span(Random& random, bool spans) {
    const int unit = osem::root_side / 8;
    osem::Point step{};
    for (std::int32_t& c : step.at) c = random.below(3) == 0 ? 0 : random.between(0, unit);
    const osem::Point a{{random.between(0, unit), random.between(0, unit), random.between(0, unit)}};
    oracle::Polygon ring;
    const int on_line = 3 + random.below(3);
    for (int i = 0; i < on_line; ++i) {
        const int k = random.below(7);
        ring.push_back({{a.x() + k * step.x(), a.y() + k * step.y(), a.z() + k * step.z()}});
    }
    if (spans) ring.push_back(random.vertex());
    return ring;
}

oracle::TestSolid random_face(Random& random, unsigned seed) {
    oracle::TestSolid face;
    switch (random.below(8)) {
    case 0:
    case 1:
        face.add_face({{random.root_corner(), random.root_corner(), random.root_corner()}});
        break;
    case 2:
        face.add_face({slow_to_span(random, true)});
        break;
    case 3:
        face.add_face({slow_to_span(random, false)});
        break;
    case 4:
        return oracle::FaceCase(seed).face();
    default:
        face.add_face({{random.vertex(), random.vertex(), random.vertex()}});
        break;
    }
    return face;
}

// A corner moved by whole parts of two edges: on the plane, where that is on the lattice.
osem::Point on_plane(Random& random, const oracle::Polygon& corners) {
    const int n = static_cast<int>(corners.size());
    const auto some = [&] { return corners[static_cast<std::size_t>(random.below(n))]; };
    osem::Point q = some();
    for (int edge = 0; edge < 2; ++edge) {
        const osem::Point from = some();
        const osem::Point to = some();
        osem::Point moved = q;
        const int share = 1 << random.below(3);
        for (int axis = 0; axis < 3; ++axis) moved.at[axis] += (to.at[axis] - from.at[axis]) / share;
        if (is_query(moved)) q = moved;
    }
    return q;
}

osem::Point query(Random& random, const oracle::Polygon& corners) {
    osem::Point q = random.query();
    switch (random.below(5)) {
    case 0:
        q = corners[static_cast<std::size_t>(random.below(static_cast<int>(corners.size())))];
        break;
    case 1:
        q = on_plane(random, corners);
        break;
    case 2:
        q = on_plane(random, corners);
        q.at[random.below(3)] += random.between(-1, 1);
        break;
    default:
        break;
    }
    return is_query(q) ? q : corners.front();
}

} // namespace

void write_plane(const std::string& folder) {
    VectorFile file(osem::cross::Topic::plane);
    Random random(12);
    for (unsigned seed = 1; seed <= faces; ++seed) {
        const oracle::TestSolid face = random_face(random, seed);
        const oracle::Polygon corners = corners_of(face);
        const std::optional<Spanning> plane = spanning(corners);
        Bytes body;
        body.solid(face.view_with_tables());
        body.u8(plane ? 0 : 1);
        for (int i = 0; i < queries; ++i) {
            const osem::Point q = query(random, corners);
            const std::int64_t value = plane ? volume(*plane, q) : 0;
            body.point(q);
            body.i64(value);
            bool extreme = is_extreme(q);
            for (const osem::Point& corner : corners) extreme = extreme || is_extreme(corner);
            file.tally().count(value == 0, extreme);
        }
        file.add_record(std::move(body));
    }
    file.write(folder);
}

} // namespace vectors
