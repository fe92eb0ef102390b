// Random faces against octants in and around which they lie.
#include "exact_face.hpp"
#include "face_case.hpp"
#include "random.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

constexpr std::uint32_t least_pairs = 100000;

// A corner of the face lies on the border of the octant.
bool touches(const oracle::TestSolid& face, const osem::Octant& octant) {
    for (const osem::Point& p : face.vertices) {
        bool on_border = false;
        bool in_closed = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t offset = p.at[axis] - octant.corner.at[axis];
            on_border = on_border || offset == 0 || offset == octant.side();
            in_closed = in_closed && 0 <= offset && offset <= octant.side();
        }
        if (on_border && in_closed) return true;
    }
    return false;
}

bool reaches_end(const oracle::TestSolid& face, const osem::Octant& octant) {
    osem::Point high = octant.corner;
    for (std::int32_t& c : high.at) c += octant.side();
    if (is_extreme(octant.corner) || is_extreme(high)) return true;
    for (const osem::Point& p : face.vertices) {
        if (is_extreme(p)) return true;
    }
    return false;
}

} // namespace

void write_classify(const std::string& folder) {
    VectorFile file(osem::cross::Topic::classify);
    for (unsigned seed = 100001; file.tally().cases < least_pairs; ++seed) {
        oracle::FaceCase random(seed);
        const oracle::TestSolid face = random.face();
        const oracle::FacePieces pieces = oracle::pieces_of(face.view_with_tables(), 0);
        const bool flat = pieces.triangles.empty();
        Bytes body;
        body.solid(face.view_with_tables());
        for (const osem::Octant& octant : random.octants()) {
            const unsigned meets = oracle::meets_open(pieces, octant) ? osem::cross::answer_meets : 0;
            const unsigned apart = oracle::boxes_overlap(face, octant) ? 0 : osem::cross::answer_minimax;
            body.point(octant.corner);
            body.u8(octant.level);
            body.u8(meets | apart);
            file.tally().count(flat || touches(face, octant), reaches_end(face, octant));
        }
        file.add_record(std::move(body));
    }
    file.write(folder);
}

} // namespace vectors
