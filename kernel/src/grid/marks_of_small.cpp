// Which octants of a grid a small triangle meets.
#include <cstddef>

#include "grid/edge_functions.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/plane_function.hpp"

namespace osem {

namespace {

// As seen along an axis: a word for each row of a box, in fours of rows. Which of so many squares of it the
// triangle is seen to meet, a bit for each, the first one lowest.
template <class Edges>
void note_squares(Edges&& edges, std::uint32_t squares, int fours, std::uint32_t* rows) {
    for (; fours > 0; --fours, rows += 4, edges.next_four()) {
        Four seen = {};
        edges.see(squares, seen);
        store(rows, seen);
    }
}

} // namespace

// As mark_convex, by the same separating axes, each row and slab of the box from its first one on. Of rows
// along x four go side by side: so the box begins where there are as many to the grid's end. False, and
// nothing marked, if the triangle is seen as a line, or its plane's numbers are too large.
bool FaceInGrid::mark_small(const Ranges& range, std::uint32_t* rows, std::uint32_t* scratch) const {
    if (!guesses_cost_much) return false; // so that parts without need have no code of it
    static_assert(last_grid_space(4) >= 3 * 16 && last_grid_space(5) >= 3 * (small_octants + 4),
                  "room for what is seen, in fours of rows");
    const std::uint32_t x_count = range[0].count();
    const int y_fours = fours_of(range[1]);
    const int z_fours = fours_of(range[2]);
    const std::uint32_t z_count = range[2].count();
    const int first_y = first_of_fours(range[1], grid_.side());
    const SmallTriangle triangle = small_triangle(
        solid_, corners_, grid_, FourSigned{range[0].first, first_y, first_y, range[2].first}, 0);
    const SmallPlane plane(triangle);
    PlaneFunction passes(plane, grid_.shift, x_count);
    if (plane.is_line_somewhere() || !passes.fits((extent_.length(axis_x) >> grid_.shift) + 2)) return false;
    std::uint32_t* const x_by_y = scratch;
    std::uint32_t* const x_by_z = x_by_y + 4 * static_cast<std::size_t>(y_fours);
    std::uint32_t* const y_by_z = x_by_z + 4 * static_cast<std::size_t>(z_fours);
    const int shift = grid_.shift;
    note_squares(EdgeFunctions<axis_x, axis_y>(triangle, plane.normal[axis_z], shift, SeenPlaces::squares),
                 x_count, y_fours, x_by_y);
    // (x, z) is left-handed.
    note_squares(EdgeFunctions<axis_x, axis_z>(triangle, -plane.normal[axis_y], shift, SeenPlaces::squares),
                 x_count, z_fours, x_by_z);
    const IndexRange y = {range[1].first - first_y, range[1].last - first_y};
    note_squares(EdgeFunctions<axis_y, axis_z>(triangle, plane.normal[axis_x], shift, SeenPlaces::squares),
                 static_cast<std::uint32_t>(y.last + 1), z_fours, y_by_z);
    const std::uint32_t all_y = y.bits();
    std::uint32_t* layer = rows + grid_.row(first_y, range[2].first);
    for (std::uint32_t k = 0; k < z_count; ++k, layer += grid_.side()) {
        for (std::uint32_t left = y_by_z[k] & all_y; left != 0;) {
            const std::uint32_t first = lowest_of(left) & ~3U;
            Four passed = {};
            passes.see_four(first, k, passed);
            Four in_y = {};
            set_where_has(in_y, left >> first);
            Four in_x = {};
            load(in_x, x_by_y + first);
            Four marked = {};
            load(marked, layer + first);
            store(layer + first, marked | (passed & x_by_z[k] & in_x & in_y) << range[0].first);
            left &= ~(std::uint32_t{15} << first);
        }
    }
    return true;
}

} // namespace osem
