// The five stages on pairs made for each, and polygons with holes against interval arithmetic.
#include "osem/classify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

// Coordinates of the cases are in units of a quarter of the octant's side, measured from its low corner.
struct SolidCase {
    const char* name;
    std::vector<std::vector<std::array<int, 3>>> rings;
    Stage stage;
    bool meets;
};

constexpr int in_quarters = 4; // the octant's side

const std::vector<SolidCase>& cases() {
    static const std::vector<SolidCase> all = {
        // Stage 1.
        {"far away", {{{9, 9, 9}, {12, 9, 9}, {9, 12, 9}}}, Stage::minimax, false},
        {"touches a side from outside", {{{4, 0, 0}, {8, 4, 0}, {8, 0, 4}}}, Stage::minimax, false},
        {"touches a side from below", {{{0, 0, 0}, {4, 0, -4}, {0, 4, -4}}}, Stage::minimax, false},
        {"lies in a side", {{{1, 1, 4}, {3, 1, 4}, {1, 3, 4}}}, Stage::minimax, false},
        {"lies in a low side", {{{0, 1, 1}, {0, 3, 1}, {0, 1, 3}}}, Stage::minimax, false},
        {"covers a side", {{{-8, 0, -8}, {12, 0, -8}, {12, 0, 12}, {-8, 0, 12}}}, Stage::minimax, false},
        {"touches an edge", {{{4, 4, 0}, {8, 4, 0}, {4, 8, 4}}}, Stage::minimax, false},
        {"zero area in a side", {{{4, 0, 0}, {4, 2, 2}, {4, 4, 4}}}, Stage::minimax, false},

        // Stage 2: the boxes overlap, the planes miss or only touch.
        {"plane past a corner", {{{15, -1, -1}, {-1, 15, -1}, {-1, -1, 15}}}, Stage::plane, false},
        {"plane through a corner alone", {{{16, -2, -2}, {-2, 16, -2}, {-2, -2, 16}}}, Stage::plane, false},
        {"plane through an edge alone",
         {{{-4, 4, -4}, {-4, 4, 8}, {4, -4, 8}, {4, -4, -4}}},
         Stage::plane,
         false},
        {"plane through a high edge alone",
         {{{8, 0, -4}, {8, 0, 8}, {0, 8, 8}, {0, 8, -4}}},
         Stage::plane,
         false},

        // Stage 3.
        {"corner strictly inside", {{{1, 1, 1}, {9, 1, 1}, {1, 9, 3}}}, Stage::vertices, true},
        {"last corner strictly inside", {{{9, 1, 1}, {1, 9, 3}, {1, 1, 1}}}, Stage::vertices, true},
        {"triangle on the octant's corners", {{{0, 0, 0}, {4, 4, 0}, {0, 4, 4}}}, Stage::vertices, true},
        {"triangle on the octant's edges", {{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}}}, Stage::vertices, true},
        {"zero area with a corner inside", {{{2, 2, 2}, {8, 8, 8}, {6, 6, 6}}}, Stage::vertices, true},
        {"a hole's corner inside",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}}, {{2, 2, 2}, {2, 8, 2}, {8, 8, 2}, {8, 2, 2}}},
         Stage::section,
         true},

        // Stage 4: an edge meets, or the section lies on one side of the only ring.
        {"an edge passes through", {{{-2, 2, 2}, {6, 2, 2}, {2, -9, 2}}}, Stage::section, true},
        {"the closing edge passes through", {{{6, 2, 2}, {2, -9, 2}, {-2, 2, 2}}}, Stage::section, true},
        {"an edge along the diagonal", {{{-4, -4, -4}, {8, 8, 8}, {8, 8, -9}}}, Stage::section, true},
        {"section inside the ring", {{{-20, -20, 2}, {40, -20, 2}, {-20, 40, 2}}}, Stage::section, true},
        {"section inside a slanted ring",
         {{{-20, -20, -18}, {40, -20, 42}, {-20, 40, -18}}},
         Stage::section,
         true},
        {"section outside the ring", {{{9, 0, 2}, {9, 9, 2}, {0, 9, 2}}}, Stage::section, false},
        {"an edge touches an octant's edge", {{{8, 0, 2}, {0, 8, 2}, {9, 9, 2}}}, Stage::section, false},
        {"an edge of the ring in a side",
         {{{0, -8, 2}, {0, 12, 2}, {8, 12, 2}, {8, 20, 2}, {-9, 20, 2}, {-9, -8, 2}}},
         Stage::section,
         false},
        {"zero area through the octant", {{{-4, 2, 2}, {8, 2, 2}, {12, 2, 2}}}, Stage::section, true},
        {"zero area along an octant's edge", {{{-4, 2, 8}, {8, 2, -4}, {14, 2, -10}}}, Stage::section, true},
        {"zero area across the octant", {{{-1, 6, 2}, {6, -1, 2}, {12, -7, 2}}}, Stage::section, true},
        {"zero area beside the octant", {{{2, 8, 2}, {8, 2, 2}, {5, 5, 2}}}, Stage::section, false},
        {"a point, thrice", {{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}}, Stage::vertices, true},
        {"a ring that runs back on itself",
         {{{0, 0, 2}, {0, 4, 2}, {0, 0, 2}, {4, 0, 2}}},
         Stage::section,
         false},

        // Stage 5.
        {"a hole covers the section exactly",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}}, {{0, 0, 2}, {0, 4, 2}, {4, 4, 2}, {4, 0, 2}}},
         Stage::holes,
         false},
        {"a hole covers more than the section",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}},
          {{-1, -1, 2}, {-1, 5, 2}, {5, 5, 2}, {5, -1, 2}}},
         Stage::holes,
         false},
        {"a hole touches from outside",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}}, {{4, 0, 2}, {4, 4, 2}, {8, 4, 2}, {8, 0, 2}}},
         Stage::holes,
         true},
        {"the second of two holes covers",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}},
          {{-4, 0, 2}, {-4, 4, 2}, {-1, 4, 2}, {-1, 0, 2}},
          {{0, 0, 2}, {0, 4, 2}, {4, 4, 2}, {4, 0, 2}}},
         Stage::holes,
         false},
        {"a slanted hole covers the section exactly",
         {{{-8, -8, -8}, {12, -8, 12}, {12, 12, 12}, {-8, 12, -8}},
          {{0, 0, 0}, {0, 4, 0}, {4, 4, 4}, {4, 0, 4}}},
         Stage::holes,
         false},
        {"outside the outer ring of a face with a hole",
         {{{5, -8, 2}, {-8, 5, 2}, {-30, 5, 2}, {5, -30, 2}}, {{-9, -9, 2}, {-9, -8, 2}, {-8, -8, 2}}},
         Stage::section,
         false},
        {"wound around by a hole that lies outside the outer ring",
         {{{-30, -30, 2}, {-20, -30, 2}, {-20, -20, 2}, {-30, -20, 2}},
          {{-1, -1, 2}, {-1, 5, 2}, {5, 5, 2}, {5, -1, 2}}},
         Stage::holes,
         true},
        {"a hole's edge passes through",
         {{{-8, -8, 2}, {12, -8, 2}, {12, 12, 2}, {-8, 12, 2}},
          {{1, -1, 2}, {1, 5, 2}, {3, 5, 2}, {3, -1, 2}}},
         Stage::section,
         true},
    };
    return all;
}

// In which of the octants of a level the cases are put.
Point place(const std::array<int, 3>& p, const Octant& octant, int turn, unsigned flip) {
    Point placed = octant.corner;
    for (int axis = 0; axis < 3; ++axis) {
        const int source = (axis + turn) % 3;
        int quarters = p[static_cast<std::size_t>(source)];
        if (((flip >> axis) & 1U) != 0) quarters = in_quarters - quarters;
        placed.at[axis] += quarters * (octant.side() / in_quarters);
    }
    return placed;
}

// Each case in every position: the axes turned, each axis reversed, both orders of corners.
TEST(Classify, EveryStageBothWays) {
    const Octant octants[] = {root_octant.child(7).child(0).child(0).child(0).child(7), // side 2^15
                              {{{777 * 4, 999 * 4, 555 * 4}}, 18}}; // side 4: quarters are units
    for (const SolidCase& c : cases()) {
        for (const Octant& octant : octants) {
            for (unsigned position = 0; position < 48; ++position) {
                std::vector<Polygon> rings;
                for (const auto& ring : c.rings) {
                    Polygon polygon;
                    for (const auto& p : ring) {
                        polygon.push_back(place(p, octant, static_cast<int>(position % 3), position / 3 % 8));
                    }
                    if (position >= 24) std::reverse(polygon.begin(), polygon.end());
                    rings.push_back(polygon);
                }
                SmallSolid face;
                face.add_face(rings);
                const Decision decision = classify(face.vouched(), 0, octant);
                EXPECT_EQ(decision.meets, c.meets) << c.name << ", position " << position;
                if (std::string(c.name) == "a hole's corner inside") continue;
                EXPECT_EQ(static_cast<int>(decision.stage), static_cast<int>(c.stage))
                    << c.name << ", position " << position;
            }
        }
    }
}

TEST(Classify, RootOctantAndItsBorder) {
    const std::int32_t end = root_side;
    SmallSolid faces;
    faces.add_face({{{{0, 0, 0}}, {{end, 0, 0}}, {{0, end, 0}}}});
    faces.add_face({{{{end, 0, 0}}, {{end, end, 0}}, {{end, end, end}}}});
    faces.add_face({{{{end, 0, 0}}, {{0, end, 0}}, {{0, 0, end}}}});
    faces.add_face({{{{0, 0, 0}}, {{end, end, end}}, {{end, end, 0}}}});
    EXPECT_FALSE(classify(faces.vouched(), 0, root_octant).meets);
    EXPECT_FALSE(classify(faces.vouched(), 1, root_octant).meets);
    EXPECT_TRUE(classify(faces.vouched(), 2, root_octant).meets);
    EXPECT_TRUE(classify(faces.vouched(), 3, root_octant).meets);
}

// Faces in planes z = x * slope + offset, rectangles with rectangular holes as seen along z: over them an
// octant's section is a rectangle too, and intervals decide.
struct Rectangle {
    std::int32_t low[2];
    std::int32_t high[2];
    bool is_empty() const { return low[0] >= high[0] || low[1] >= high[1]; }
};

// The open section against the closed outer rectangle without the open holes. The section is connected: one
// that reaches the outer one and is in no hole either lies in the outer one or crosses its ring.
bool section_meets(const Rectangle& section, const Rectangle& outer, const std::vector<Rectangle>& holes) {
    if (section.is_empty()) return false;
    for (int i = 0; i < 2; ++i) {
        if (section.high[i] <= outer.low[i] || section.low[i] >= outer.high[i]) return false;
    }
    return std::none_of(holes.begin(), holes.end(), [&](const Rectangle& hole) {
        return section.low[0] >= hole.low[0] && section.high[0] <= hole.high[0] &&
               section.low[1] >= hole.low[1] && section.high[1] <= hole.high[1];
    });
}

class RandomFace {
  public:
    explicit RandomFace(std::uint32_t seed) : random_(seed), turn_(static_cast<int>(seed % 3)) {
        slope_ = static_cast<int>(random_() % 3) - 1;
        offset_ = static_cast<std::int32_t>(slope_ < 0 ? 8 : 0) + (slope_ == 0 ? between(0, 8) : 0);
        outer_ = rectangle(0, 8, 0, 8);
        const std::int32_t middle = between(outer_.low[0], outer_.high[0]);
        // Up to two holes, side by side, which may touch each other and the outer ring.
        for (const auto& [from, to] : {std::pair{outer_.low[0], middle}, std::pair{middle, outer_.high[0]}}) {
            if (to > from && random_() % 3 != 0) {
                holes_.push_back(rectangle(from, to, outer_.low[1], outer_.high[1]));
            }
        }
    }

    SmallSolid solid(std::int32_t unit) const {
        std::vector<Polygon> rings = {ring(outer_, false, unit)};
        for (const Rectangle& hole : holes_) rings.push_back(ring(hole, true, unit));
        SmallSolid solid;
        solid.add_face(rings);
        return solid;
    }

    /// Whether it meets the octant, which is in units.
    bool meets(const Octant& octant, std::int32_t unit) const {
        std::int32_t low[3];
        std::int32_t high[3];
        for (int axis = 0; axis < 3; ++axis) { // back to the face's own axes, x, y and z
            low[(axis + turn_) % 3] = octant.corner.at[axis] / unit;
            high[(axis + turn_) % 3] = (octant.corner.at[axis] + octant.side()) / unit;
        }
        Rectangle section = {{low[0], low[1]}, {high[0], high[1]}};
        if (slope_ == 0 && !(low[2] < offset_ && offset_ < high[2])) return false;
        if (slope_ != 0) { // the x at which the plane enters and leaves the octant's height
            const std::int32_t at_low = slope_ * (low[2] - offset_);
            const std::int32_t at_high = slope_ * (high[2] - offset_);
            section.low[0] = std::max(section.low[0], std::min(at_low, at_high));
            section.high[0] = std::min(section.high[0], std::max(at_low, at_high));
        }
        return section_meets(section, outer_, holes_);
    }

  private:
    std::int32_t between(std::int32_t low, std::int32_t high) {
        return low + static_cast<std::int32_t>(random_() % static_cast<std::uint32_t>(high - low + 1));
    }
    Rectangle rectangle(std::int32_t x0, std::int32_t x1, std::int32_t y0, std::int32_t y1) {
        Rectangle r = {{between(x0, x1 - 1), between(y0, y1 - 1)}, {0, 0}};
        r.high[0] = between(r.low[0] + 1, x1);
        r.high[1] = between(r.low[1] + 1, y1);
        return r;
    }
    Polygon ring(const Rectangle& r, bool is_hole, std::int32_t unit) const {
        Polygon polygon;
        for (const auto& [x, y] : {std::pair{r.low[0], r.low[1]}, std::pair{r.high[0], r.low[1]},
                                   std::pair{r.high[0], r.high[1]}, std::pair{r.low[0], r.high[1]}}) {
            const std::int32_t own[3] = {x, y, slope_ * x + offset_};
            Point p = {};
            for (int axis = 0; axis < 3; ++axis) p.at[axis] = own[(axis + turn_) % 3] * unit;
            polygon.push_back(p);
        }
        if (is_hole) std::reverse(polygon.begin(), polygon.end());
        return polygon;
    }

    std::mt19937 random_;
    int turn_;
    int slope_ = 0;
    std::int32_t offset_ = 0;
    Rectangle outer_ = {};
    std::vector<Rectangle> holes_;
};

TEST(Classify, FacesWithHolesAgainstIntervals) {
    const std::int32_t unit = root_side / 8;
    std::uint32_t outcomes[stage_count][2] = {};
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        const RandomFace face(seed);
        const SmallSolid solid = face.solid(unit);
        const CheckedSolid checked = solid.vouched();
        for (int level = 0; level <= 3; ++level) {
            const std::uint32_t count = 1U << (3 * level);
            for (std::uint32_t i = 0; i < count; ++i) {
                Octant octant = root_octant;
                for (int l = level; l-- > 0;) octant = octant.child((i >> (3 * l)) & 7U);
                const Decision decision = classify(checked, 0, octant);
                ASSERT_EQ(decision.meets, face.meets(octant, unit))
                    << "seed " << seed << ", level " << level << ", octant " << i;
                ++outcomes[static_cast<int>(decision.stage)][decision.meets ? 1 : 0];
            }
        }
    }
    EXPECT_GT(outcomes[static_cast<int>(Stage::section)][1], 0U);
    EXPECT_GT(outcomes[static_cast<int>(Stage::holes)][0], 0U);
    EXPECT_GT(outcomes[static_cast<int>(Stage::holes)][1], 0U);
}

} // namespace

} // namespace osem::tests
