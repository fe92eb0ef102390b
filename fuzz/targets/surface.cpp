// From trees back to boundary representations: closed, oriented, manifold, the faces that brute force finds;
// and the tree comes back, from the surface itself and from each file that the tool writes of it.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mesh/bad_input.hpp"
#include "mesh/quantize.hpp"
#include "mesh/readers.hpp"
#include "mesh/tree_surface.hpp"
#include "mesh/write_surface.hpp"
#include "osem/boundary.hpp"
#include "osem/grid_convert.hpp"
#include "osem/transform.hpp"
#include "support/any_grid.hpp"
#include "support/check_model.hpp"
#include "support/heap_pool.hpp"
#include "support/surface.hpp"
#include "support/surface_sheets.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

struct Arrays {
    explicit Arrays(const BoundarySizes& sizes)
        : vertices(sizes.vertices), corners(sizes.corners), ring_starts(sizes.rings + 1),
          face_rings(sizes.faces + 1) {}
    BoundaryArrays view() { return {vertices.data(), corners.data(), ring_starts.data(), face_rings.data()}; }

    std::vector<Point> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts;
    std::vector<std::uint32_t> face_rings;
};

/// Counted, then with too little scratch, then with enough, by steps of any size.
BoundaryOutcome build(Boundary& job, const Octree& tree, SolidPart part, std::vector<BoundaryCorner>& scratch,
                      Choices& choices) {
    job.begin(tree, part, nullptr, 0);
    step_through(job, choices);
    const BoundaryOutcome counted = job.finish();
    EXPECT_EQ(counted.status, Status::ok);
    const std::uint32_t entries = boundary_scratch(counted.sizes.corners);
    if (entries > 0) {
        const std::uint32_t too_few = choices.below(entries);
        scratch.resize(too_few);
        if (too_few > 0) { // a null pointer makes a counting pass
            job.begin(tree, part, scratch.data(), too_few);
            step_through(job, choices);
            EXPECT_EQ(job.finish().status, Status::scratch_too_small);
            EXPECT_EQ(job.finish().scratch_missing, entries - too_few);
        }
    }
    scratch.assign(entries, BoundaryCorner{});
    job.begin(tree, part, scratch.data(), entries);
    step_through(job, choices);
    const BoundaryOutcome outcome = job.finish();
    EXPECT_EQ(outcome.sizes.vertices, counted.sizes.vertices);
    EXPECT_EQ(outcome.sizes.corners, counted.sizes.corners);
    return outcome;
}

/// Vertices on two edges only: such a one stands one unit behind a vertex at which both copies of a cut edge
/// start.
std::uint32_t dividing_vertices(const Solid& surface) {
    std::vector<std::set<std::uint32_t>> joined(surface.vertex_count);
    for (std::uint32_t r = 0; r < surface.ring_count(); ++r) {
        const Ring ring = surface.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            joined[ring.corners[i]].insert(ring.corners[(i + 1) % ring.count]);
        }
    }
    const auto is_ahead = [&](std::uint32_t from, std::uint32_t to) {
        int axes = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t way = surface.vertices[to].at[axis] - surface.vertices[from].at[axis];
            if (way < 0) return false;
            axes += way > 0 ? 1 : 0;
        }
        return axes == 1;
    };
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < surface.vertex_count; ++v) {
        if (joined[v].size() != 2) continue;
        ++count;
        const std::uint32_t start =
            is_ahead(*joined[v].begin(), v) ? *joined[v].begin() : *joined[v].rbegin();
        EXPECT_TRUE(is_ahead(start, v));
        const auto copies =
            std::count_if(joined[start].begin(), joined[start].end(), [&](std::uint32_t other) {
                for (int axis = 0; axis < 3; ++axis) {
                    const bool along = surface.vertices[v].at[axis] > surface.vertices[start].at[axis];
                    if (along != (surface.vertices[other].at[axis] > surface.vertices[start].at[axis]))
                        return false;
                }
                return is_ahead(start, other);
            });
        EXPECT_EQ(copies, 2);
    }
    return count;
}

/// Six times the volume of the cells, and what a disk with holes adds up to.
void expect_measures(const Solid& surface, const tests::DenseGrid& solid) {
    EXPECT_EQ(tests::six_volumes(surface, solid.cell_side()),
              static_cast<std::int64_t>(6 * solid.volume(Colour::black) / volume_at(solid.depth())));
    const tests::SheetCounts sheets = tests::count_sheets(solid);
    EXPECT_EQ(surface.vertex_count, sheets.vertices + dividing_vertices(surface));
    EXPECT_EQ(std::int64_t{surface.vertex_count} - surface.corner_count / 2 +
                  2 * std::int64_t{surface.face_count} - surface.ring_count(),
              sheets.euler);
}

void expect_converts_back(const CheckedSolid& surface, const tests::DenseGrid& solid, WindingRule winding) {
    GridConversion job;
    tests::HeapPool pool(4000);
    std::vector<std::uint32_t> scratch(grid_scratch(surface.view(), solid.depth()));
    const TreeOutcome back = convert(job, surface, {solid.depth(), LeafRule::conservative, winding},
                                     scratch.data(), static_cast<std::uint32_t>(scratch.size()), &*pool);
    ASSERT_EQ(back.status, Status::ok);
    EXPECT_EQ(digest(back.tree), tests::expected_digest(solid));
}

/// A sink that refuses hears no more.
struct Refusing {
    std::uint32_t left;
    bool refused = false;
    static bool take(void* context) {
        auto& self = *static_cast<Refusing*>(context);
        EXPECT_FALSE(self.refused);
        self.refused = self.left == 0;
        if (!self.refused) --self.left;
        return !self.refused;
    }
    BoundarySink sink() {
        return {[](void* context, const Point&) { return take(context); },
                [](void* context, std::uint32_t) { return take(context); }, take, take, this};
    }
};

void test_refusal(Boundary& job, Choices& choices) {
    Refusing refusing = {choices.byte()};
    ASSERT_EQ(job.emit(refusing.sink()), Status::ok);
    step_through(job, choices);
    EXPECT_EQ(job.finish().status, refusing.refused ? Status::sink_refused : Status::ok);
}

/// Through a file of each format. Coordinates are exact in each, as the cube is 2^k wide at whole numbers.
void test_files(const Octree& tree, SolidPart part, const tests::DenseGrid& solid, Choices& choices) {
    const auto report = [](std::uint64_t, std::uint64_t) {};
    const auto format = static_cast<host::SurfaceFormat>(choices.below(4));
    const bool keeps_faces = format == host::SurfaceFormat::poly;
    host::TreeSurface surface = host::surface_of(tree, part, report);
    if (!keeps_faces) surface = host::in_simple_faces(surface, format != host::SurfaceFormat::stl, report);
    if (surface.face_count() == 0) return;
    const host::WorldCube cube = {
        {static_cast<double>(choices.between(-8, 8)), static_cast<double>(choices.between(-8, 8)), 0},
        static_cast<double>(1U << choices.below(12))};
    std::ostringstream out;
    host::write_surface(out, surface, cube, format);
    const std::string text = out.str();
    const host::Mesh mesh = format == host::SurfaceFormat::off   ? host::read_off(text)
                            : format == host::SurfaceFormat::obj ? host::read_obj(text)
                            : format == host::SurfaceFormat::stl ? host::read_stl(text)
                                                                 : host::read_poly(text);
    const host::IntegerSolid back = host::quantize(mesh, cube);
    expect_converts_back(host::check_or_throw(back), solid,
                         keeps_faces ? WindingRule::odd : WindingRule::nonzero);
}

/// The same at the greatest depth, where an edge of one cell has no point to be divided at.
void test_smallest_cells(const tests::DenseGrid& grid, SolidPart part, std::uint32_t dividing,
                         Choices& choices) {
    tests::HeapPool pool(4000);
    const Octree tree = tests::planted(grid, *pool);
    Octant octant = root_octant;
    while (octant.level < max_depth - grid.depth()) octant = octant.child(choices.below(8));
    const TreeOutcome small = reduced(tree, octant, *pool);
    const TreeOutcome solid = reduced(tests::planted(tests::solid_cells(grid, part), *pool), octant, *pool);
    ASSERT_TRUE(small.status == Status::ok && solid.status == Status::ok);
    Boundary job;
    std::vector<BoundaryCorner> scratch;
    const BoundaryOutcome outcome = build(job, small.tree, part, scratch, choices);
    const tests::SheetCounts sheets = tests::count_sheets(tests::solid_cells(grid, part));
    EXPECT_EQ(outcome.sizes.vertices + outcome.double_edges, sheets.vertices + dividing);
    Arrays arrays(outcome.sizes);
    const Solid surface = boundary_solid(job, arrays.view());
    const CheckOutcome checked = checked_as_expected(surface);
    ASSERT_EQ(checked.status, Status::ok);
    GridConversion back;
    std::vector<std::uint32_t> words(grid_scratch(surface, max_depth));
    const TreeOutcome converted = convert(back, checked.solid, {max_depth}, words.data(),
                                          static_cast<std::uint32_t>(words.size()), &*pool);
    ASSERT_EQ(converted.status, Status::ok);
    EXPECT_TRUE(same_leaves(converted.tree, solid.tree));
}

void test_surface(const tests::DenseGrid& grid, SolidPart part, Choices& choices) {
    tests::HeapPool pool(4000);
    const Octree tree = tests::planted(grid, *pool);
    const tests::DenseGrid solid = tests::solid_cells(grid, part);
    Boundary job;
    std::vector<BoundaryCorner> scratch;
    const BoundaryOutcome outcome = build(job, tree, part, scratch, choices);
    ASSERT_EQ(outcome.status, Status::ok);
    EXPECT_EQ(outcome.double_edges, 0U);
    if (scratch.empty()) {
        EXPECT_EQ(solid.volume(Colour::black), 0U);
        return;
    }
    if (choices.below(4) == 0) test_refusal(job, choices);
    Arrays arrays(outcome.sizes);
    const Solid surface = boundary_solid(job, arrays.view());
    const std::set<tests::UnitFaces> expected = tests::expected_faces(solid);
    EXPECT_EQ(surface.face_count, expected.size());
    EXPECT_TRUE(tests::covered_faces(surface, grid.depth()) == expected);
    EXPECT_TRUE(tests::is_manifold(surface, solid));
    expect_measures(surface, solid);
    const CheckOutcome checked = checked_as_expected(surface);
    ASSERT_EQ(checked.status, Status::ok);
    expect_converts_back(checked.solid, solid, WindingRule::nonzero);
    if (choices.below(4) == 0) test_smallest_cells(grid, part, dividing_vertices(surface), choices);
    test_files(tree, part, solid, choices);
}

} // namespace

void run(Choices& choices) {
    const auto part = static_cast<osem::SolidPart>(choices.below(2));
    const int depth = 1 + static_cast<int>(choices.below(3));
    const osem::tests::DenseGrid grid = any_grid(depth, choices);
    test_surface(grid, part, choices);
}

} // namespace osem::fuzz
