// Every face of a 4 x 4 x 4 lattice of points, against octants of four sizes that lie in it, hold it or touch
// it, and steps between reference points through it. Each answer is compared with one found by clipping, or
// by solving for the point of intersection (lattice_faces.hpp).
//
//      41,664  sets of three points (376 of them collinear): triangles, in all six orders, against every such
//              octant and the boxes of a bintree, and every step
//     193,728  rings of four points of a plane, crossing themselves, not convex and flat ones among them:
//              against the octants in places that are theirs, and every step
//       6,144  convex rings of four points with a triangle strictly inside them as a hole: as triangles
//     913,536  the same where the hole may touch the ring: against the octants in places that are theirs, and
//              steps of the points' distance
//
// in all 737,848,704 answers about boxes and 1,337,592,960 about steps, and 241,536 conversions of a face
// together with its other side, which has no inside: winding numbers are counted, but end at 0. All are taken
// where GCC optimises; Clang's builds, sanitizers, builds for debugging and machines that are emulated take
// every 61st face: they look for other things, and most of them are slow.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "classify/box.hpp"
#include "classify/crossing.hpp"
#include "osem/bintree.hpp"
#include "osem/convert.hpp"
#include "osem/grid_convert.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/lattice_faces.hpp"

namespace osem::tests {

namespace {

#ifdef __has_feature // Clang's way to say what GCC says by a macro
#define OSEM_TESTS_SANITIZED __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define OSEM_TESTS_SANITIZED 1
#else
#define OSEM_TESTS_SANITIZED 0
#endif
#if OSEM_TESTS_SANITIZED || !defined(NDEBUG) || !defined(__x86_64__) || defined(__clang__)
constexpr std::size_t face_stride = 61;
#else
constexpr std::size_t face_stride = 1;
#endif
constexpr int shards = 4; // side by side, each takes its share of the faces

// The lattice of points on the kernel's lattice: a half of their distance is `unit`, and `origin` is where
// coordinate 0 lies.
struct Placed {
    std::array<Point, lattice_points> points;

    Placed(const Point& origin, std::int32_t unit) : points() {
        for (int i = 0; i < lattice_points; ++i) {
            const Halves p = lattice_point(i);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                points[static_cast<std::size_t>(i)].at[axis] = origin.at[axis] + unit * p[axis];
            }
        }
    }
};

// A face's tables for the kernel; the vertices are those of a placement. With its other side the face is a
// closed surface that has no inside.
class KernelFace {
  public:
    KernelFace(const LatticeFace& face, bool both_sides) {
        add(face);
        if (!both_sides) return;
        LatticeFace other = face;
        for (auto& ring : other.rings) std::reverse(ring.begin(), ring.end());
        add(other);
    }
    Solid on(const Placed& placed) const {
        const auto count = static_cast<std::uint32_t>(corners_.size());
        const bool mesh = face_rings_.size() == ring_starts_.size() && count == 3 * (face_rings_.size() - 1);
        return {placed.points.data(),
                lattice_points,
                corners_.data(),
                count,
                mesh ? nullptr : ring_starts_.data(),
                mesh ? nullptr : face_rings_.data(),
                static_cast<std::uint32_t>(face_rings_.size() - 1)};
    }

  private:
    void add(const LatticeFace& face) {
        for (const auto& ring : face.rings) {
            for (const int i : ring) corners_.push_back(static_cast<std::uint32_t>(i));
            ring_starts_.push_back(static_cast<std::uint32_t>(corners_.size()));
        }
        face_rings_.push_back(static_cast<std::uint32_t>(ring_starts_.size() - 1));
    }
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> ring_starts_{0};
    std::vector<std::uint32_t> face_rings_{0};
};

std::vector<Interval> intervals(int side, int first, int step, int last) {
    std::vector<Interval> list;
    for (int low = first; low <= last; low += step) list.push_back({low, low + side});
    return list;
}
BoxForm cubes(int side, int first, int step, int last) {
    const std::vector<Interval> list = intervals(side, first, step, last);
    return {list, list, list};
}

// Boxes of a form, and for each the placement of the points that makes it an octant (or a block of a bintree)
// of the kernel's lattice: at its finest scale beside the root's far corner, or at the coarsest.
class PlacedBoxes {
  public:
    PlacedBoxes(const BoxForm& form, bool finest) : form_(form) {
        const std::int32_t unit = finest ? 1 : root_side / 32;
        const Point corner =
            finest ? Point{{root_side - 16, 8, root_side / 2}} : Point{{8 * unit, 16 * unit, 8 * unit}};
        for (const Interval& z : form[2]) {
            for (const Interval& y : form[1]) {
                for (const Interval& x : form[0]) {
                    const std::array<Interval, 3> of = {x, y, z};
                    Box box = {corner, corner};
                    Point origin = corner;
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        box.hi.at[axis] += unit * (of[axis].high - of[axis].low);
                        origin.at[axis] -= unit * of[axis].low;
                    }
                    boxes_.push_back(box);
                    placed_.emplace_back(origin, unit);
                }
            }
        }
    }

    const BoxForm& form() const { return form_; }
    std::size_t size() const { return boxes_.size(); }

    /// The first box about which the kernel says something else than `met`; size() when there is none.
    std::size_t first_difference(const KernelFace& face, const std::vector<bool>& met) const {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (classify_box(face.on(placed_[i]), 0, boxes_[i]).meets != met[i]) return i;
        }
        return size();
    }

  private:
    BoxForm form_;
    std::vector<Box> boxes_;
    std::vector<Placed> placed_;
};

std::vector<PlacedBoxes> octants() {
    std::vector<PlacedBoxes> boxes;
    for (const bool finest : {false, true}) {
        boxes.emplace_back(cubes(1, -1, 1, 6), finest);
        boxes.emplace_back(cubes(2, -2, 1, 6), finest);
        boxes.emplace_back(cubes(4, -4, 2, 6), finest);
        boxes.emplace_back(cubes(8, -8, 2, 6), finest);
    }
    return boxes;
}

// Octants, and blocks whose sides along x and y are as long as the one along z or twice as long.
std::vector<PlacedBoxes> all_boxes() {
    std::vector<PlacedBoxes> boxes = octants();
    const std::vector<Interval> one = intervals(1, -1, 1, 6);
    const std::vector<Interval> two = intervals(2, -2, 2, 6);
    boxes.emplace_back(BoxForm{two, one, one}, true);
    boxes.emplace_back(BoxForm{one, two, one}, true);
    boxes.emplace_back(BoxForm{two, two, one}, false);
    return boxes;
}

// Octants of each size at one scale, in all places that are theirs when the lattice begins at the root.
std::vector<PlacedBoxes> aligned_octants() {
    std::vector<PlacedBoxes> boxes;
    boxes.emplace_back(cubes(1, 0, 1, 5), true);
    boxes.emplace_back(cubes(2, -2, 2, 6), false);
    boxes.emplace_back(cubes(4, -4, 4, 4), true);
    boxes.emplace_back(cubes(8, 0, 8, 0), false);
    return boxes;
}

// The face in another order: each ring begins elsewhere, and all of them run the other way if `n` is odd.
LatticeFace turned(const LatticeFace& face, std::size_t n) {
    LatticeFace result = face;
    for (auto& ring : result.rings) {
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(n / 2 % ring.size()),
                    ring.end());
        if (n % 2 != 0) std::reverse(ring.begin(), ring.end());
    }
    return result;
}

std::string text(const LatticeFace& face) {
    std::string all;
    for (const auto& ring : face.rings) {
        for (const int i : ring) all += std::to_string(i) + " ";
        all += "; ";
    }
    return all;
}

class ExhaustiveLattice : public ::testing::TestWithParam<int> {
  protected:
    // Runs `check` on every face of the shard, with its number, and says how many cases that made.
    template <class Check>
    void for_all(const std::vector<LatticeFace>& faces, const Check& check) {
        std::size_t looked_at = 0;
        const auto shard = static_cast<std::size_t>(GetParam());
        for (std::size_t i = shard * face_stride; i < faces.size(); i += shards * face_stride) {
            ASSERT_NO_FATAL_FAILURE(check(faces[i], i)) << "face " << i << ": points " << text(faces[i]);
            ++looked_at;
        }
        std::cout << looked_at << " faces of " << faces.size() << ", " << cases << " cases\n";
        RecordProperty("cases", std::to_string(cases));
    }

    // Each form of boxes in `orders` of the eight ways to write a ring of four, or the six to write one of
    // three: others with every face and form.
    void expect_boxes(const std::vector<LatticeFace>& faces, const std::vector<PlacedBoxes>& all,
                      std::size_t orders) {
        for_all(faces, [&](const LatticeFace& face, std::size_t number) {
            std::size_t order = number;
            for (const PlacedBoxes& boxes : all) {
                const std::vector<bool> met = boxes_met(face, boxes.form());
                for (std::size_t n = 0; n < orders; ++n, ++order) {
                    const KernelFace in_order(turned(face, order), false);
                    ASSERT_EQ(boxes.first_difference(in_order, met), boxes.size()) << "order " << order;
                }
                cases += orders * boxes.size();
            }
        });
    }

    // Steps of these lengths along each axis, from every point of halves in the lattice and around it.
    void expect_steps(const std::vector<LatticeFace>& faces, const std::vector<int>& lengths, int around) {
        constexpr std::int32_t unit = root_side / 16; // steps stay in the root
        const Placed placed({{unit, unit / 2 * 3, unit}}, unit);
        for_all(faces, [&](const LatticeFace& face, std::size_t number) {
            const LatticeFace in_order = turned(face, number);
            const KernelFace tables(in_order, false);
            const Solid solid = tables.on(placed);
            for (const int length : lengths) {
                for (int axis = 0; axis < 3; ++axis) {
                    expect_steps_along(in_order, solid, axis, length, around, unit);
                }
            }
        });
    }

    void expect_steps_along(const LatticeFace& face, const Solid& solid, int axis, int length, int around,
                            std::int32_t unit) {
        const Point origin = {{unit, unit / 2 * 3, unit}};
        for (int x = -around; x < 6; ++x) {
            for (int y = -around; y < 6; ++y) {
                for (int z = -around; z < 6; ++z) {
                    const Point from = {
                        {origin.x() + x * unit, origin.y() + y * unit, origin.z() + z * unit}};
                    ++cases;
                    ASSERT_EQ(crossing(solid, 0, from, static_cast<Axis>(axis), length * unit),
                              winding_added(face, {x, y, z}, axis, length))
                        << "from " << x << " " << y << " " << z << ", axis " << axis << ", " << length;
                }
            }
        }
    }

    // The face and its other side converted into leaves of half the points' distance, each time by another
    // technique: boundary where the face meets a leaf, else white.
    void expect_conversions(const std::vector<LatticeFace>& faces) {
        const BoxForm leaves = cubes(1, 0, 1, 5);
        for_all(faces, [&](const LatticeFace& face, std::size_t number) {
            const int shift = static_cast<int>(number / 5 % 2);
            const std::int32_t unit = root_side / 8;
            const Placed placed({{2 * shift * unit, 2 * shift * unit, 2 * shift * unit}}, unit);
            const KernelFace both(turned(face, number), true);
            const std::vector<bool> met = boxes_met(face, leaves);
            const DenseGrid expected = make_grid(3, [&](const Point& corner, std::int32_t) {
                std::size_t index = 0;
                for (int axis = 2; axis >= 0; --axis) {
                    const int at = corner.at[axis] / unit - 2 * shift;
                    if (at < 0 || at > 5) return Colour::white;
                    index = 6 * index + static_cast<std::size_t>(at);
                }
                return met[index] ? Colour::boundary : Colour::white;
            });
            ASSERT_EQ(digest_of(CheckedSolid::vouched(both.on(placed)), number), expected_digest(expected));
            ++cases;
        });
    }

    std::uint64_t digest_of(const CheckedSolid& solid, std::size_t number) {
        const std::uint32_t faces = convert_scratch(solid.view());
        pool->roll_back(0);
        if (number % 5 == 0) {
            return digest(convert(plain, solid, {3}, words.data(), faces, &*pool).tree);
        }
        if (number % 5 == 1) {
            return digest(convert_by_labelling(labelling, solid, 3, WindingRule::nonzero, words.data(), faces,
                                               words.data() + faces, 4000, &*pool)
                              .built.tree);
        }
        const int levels = static_cast<int>(number % 5) - 1;
        EXPECT_EQ(grids.begin(solid, {3}, words.data(), static_cast<std::uint32_t>(words.size()), &*pool,
                              {levels, root_octant}),
                  Status::ok);
        while (grids.step(UINT32_MAX)) {
        }
        return digest(grids.finish().tree);
    }

    std::uint64_t cases = 0;
    HeapPool pool{600};
    std::vector<std::uint32_t> words = std::vector<std::uint32_t>(8000);
    Conversion plain;
    Labelling labelling;
    GridConversion grids;
};

TEST_P(ExhaustiveLattice, TrianglesAndBoxes) { expect_boxes(lattice_triangles(), all_boxes(), 1); }
TEST_P(ExhaustiveLattice, QuadsAndBoxes) { expect_boxes(lattice_quads(), aligned_octants(), 2); }
TEST_P(ExhaustiveLattice, QuadsWithHoleAndBoxes) {
    expect_boxes(lattice_quads_with_hole(false), all_boxes(), 2);
}
TEST_P(ExhaustiveLattice, QuadsWithTouchingHoleAndBoxes) {
    expect_boxes(lattice_quads_with_hole(true), aligned_octants(), 1);
}

TEST_P(ExhaustiveLattice, TrianglesAndSteps) { expect_steps(lattice_triangles(), {1, 2, 4}, 1); }
TEST_P(ExhaustiveLattice, QuadsAndSteps) { expect_steps(lattice_quads(), {1, 2, 4}, 1); }
TEST_P(ExhaustiveLattice, QuadsWithHoleAndSteps) {
    expect_steps(lattice_quads_with_hole(false), {1, 2, 4}, 1);
}

TEST_P(ExhaustiveLattice, QuadsWithTouchingHoleAndSteps) {
    expect_steps(lattice_quads_with_hole(true), {2}, 0);
}

TEST_P(ExhaustiveLattice, TrianglesConverted) { expect_conversions(lattice_triangles()); }
TEST_P(ExhaustiveLattice, QuadsConverted) { expect_conversions(lattice_quads()); }
TEST_P(ExhaustiveLattice, QuadsWithHoleConverted) { expect_conversions(lattice_quads_with_hole(false)); }

INSTANTIATE_TEST_SUITE_P(Shard, ExhaustiveLattice, ::testing::Range(0, shards));

} // namespace

} // namespace osem::tests
