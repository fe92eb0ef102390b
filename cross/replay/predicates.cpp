// The predicates of one face: orientation, plane, classify, crossing.
#include <initializer_list>

#include "classify/crossing.hpp"
#include "geometry/plane.hpp"
#include "geometry/sight.hpp"
#include "osem/classify.hpp"
#include "records.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

// Both forms of a triangle; the one form of any other face.
struct Forms {
    Solid solid[2];
    unsigned count;
};

bool read_forms(Reader& reader, Arena& arena, Forms& forms) {
    if (!read_solid(reader, arena, forms.solid[0])) return false;
    forms.count = 1;
    if (forms.solid[0].ring_count() != 1 || forms.solid[0].corner_count != 3) return true;
    forms.solid[1] = forms.solid[0];
    forms.solid[1].ring_starts = nullptr;
    forms.solid[1].face_rings = nullptr;
    forms.count = 2;
    return true;
}

void expect_turn(const char* what, Reader& reader, Report& report, const Sight& sight, const Point& a,
                 const Point& b) {
    report.expect(what, reader.i64(), turn(sight.see(a), sight.see(b)).value());
}

} // namespace

bool replay_orientation(Reader& reader, Arena&, Report& report) {
    const Point a = reader.point();
    const Point b = reader.point();
    for (std::uint32_t left = reader.cases(); left > 0; --left) {
        report.begin_case();
        const Point q = reader.point();
        for (const auto along : {axis_x, axis_y, axis_z}) {
            expect_turn("orientation along an axis", reader, report, Sight(q, along), a, b);
        }
        for (const auto& lean : diagonals) {
            expect_turn("orientation along a diagonal", reader, report, Sight(q, axis_x, lean[0], lean[1]), a,
                        b);
        }
    }
    return true;
}

bool replay_plane(Reader& reader, Arena& arena, Report& report) {
    Forms forms = {};
    if (!read_forms(reader, arena, forms)) return false;
    const int collinear = reader.u8();
    for (std::uint32_t left = reader.cases(); left > 0; --left) {
        report.begin_case();
        const Point q = reader.point();
        const std::int64_t value = reader.i64();
        for (unsigned form = 0; form < forms.count; ++form) {
            const Plane plane(forms.solid[form], 0);
            report.expect("null normal", collinear, plane.is_null() ? 1 : 0);
            report.expect("plane value", value, plane.at(q).value());
        }
    }
    return true;
}

bool replay_classify(Reader& reader, Arena& arena, Report& report) {
    Forms forms = {};
    if (!read_forms(reader, arena, forms)) return false;
    for (std::uint32_t left = reader.cases(); left > 0; --left) {
        report.begin_case();
        const Point corner = reader.point();
        const Octant octant = {corner, reader.u8()};
        const std::uint8_t answer = reader.u8();
        for (unsigned form = 0; form < forms.count; ++form) {
            const Decision decision = classify(CheckedSolid::vouched(forms.solid[form]), 0, octant);
            report.expect("meets", (answer & answer_meets) != 0 ? 1 : 0, decision.meets ? 1 : 0);
            report.expect("decided by minimax", (answer & answer_minimax) != 0 ? 1 : 0,
                          decision.stage == Stage::minimax ? 1 : 0);
        }
    }
    return true;
}

bool replay_crossing(Reader& reader, Arena& arena, Report& report) {
    Forms forms = {};
    if (!read_forms(reader, arena, forms)) return false;
    for (std::uint32_t left = reader.cases(); left > 0; --left) {
        report.begin_case();
        const Point from = reader.point();
        const auto axis = static_cast<Axis>(reader.u8());
        const std::int32_t length = reader.i32();
        const std::int32_t change = reader.i32();
        for (unsigned form = 0; form < forms.count; ++form) {
            report.expect("crossing", change, crossing(forms.solid[form], 0, from, axis, length));
        }
    }
    return true;
}

} // namespace osem::cross
