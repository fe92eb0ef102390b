// Questions to trees given by their leaves, answered by brute force on their cells.
#include <algorithm>

#include "grid_leaves.hpp"
#include "random.hpp"
#include "support/query_oracles.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::Leaf;
using osem::Octant;
using osem::Point;
using osem::root_side;
using osem::tests::DenseGrid;
using osem::tests::expected_contact;
using osem::tests::expected_crossings;
using osem::tests::expected_nearest;
using osem::tests::expected_stays;

constexpr unsigned all_colours = 0x0f;
constexpr int segments = 12;
constexpr int points = 12;
constexpr int octants = 12;
constexpr int offsets = 8;

class Writer {
  public:
    explicit Writer(VectorFile& file) : file_(file) {}

    void add(const DenseGrid& a, const DenseGrid& b) {
        Bytes body;
        put_grid(body, a);
        put_grid(body, b);
        body.u8(segments);
        for (int i = 0; i < segments; ++i) put_segment(body, a);
        body.u8(points);
        for (int i = 0; i < points; ++i) put_nearest(body, a);
        body.u8(octants);
        for (int i = 0; i < octants; ++i) put_neighbour(body, a);
        body.u8(offsets);
        for (int i = 0; i < offsets; ++i) put_collision(body, a, b);
        file_.add_record(std::move(body));
    }

  private:
    Point in_sixteenths(std::int32_t low, std::int32_t high) {
        Point p = {};
        for (std::int32_t& c : p.at) c = random_.between(low, high);
        return p;
    }

    // Half of the segments run along faces, edges or diagonals of cells.
    void put_segment(Bytes& body, const DenseGrid& grid) {
        const Point from = in_sixteenths(-8, 24);
        Point to = in_sixteenths(-8, 24);
        const bool special = random_.below(2) == 0;
        const std::int32_t length = random_.between(-16, 16);
        for (unsigned axis = 0; axis < 3 && special; ++axis) {
            to.at[axis] = from.at[axis] + length * random_.between(-1, 1);
        }
        const auto crossings =
            expected_crossings(expected_stays(osem::tests::cells_of(grid, all_colours), from, to));
        body.point(osem::tests::in_units(from));
        body.point(osem::tests::in_units(to));
        body.u8(crossings.size());
        for (const osem::Crossing& crossing : crossings) {
            body.i32(std::int64_t{crossing.at.numerator} * osem::tests::unit);
            body.i32(std::int64_t{crossing.at.denominator} * osem::tests::unit);
            body.u8(crossing.axis);
            body.u8(static_cast<std::uint64_t>(crossing.before));
            body.u8(static_cast<std::uint64_t>(crossing.after));
        }
        file_.tally().count(special, false);
    }

    void put_nearest(Bytes& body, const DenseGrid& grid) {
        const bool on_planes = random_.below(2) == 0;
        const Point from = on_planes ? osem::tests::in_units(in_sixteenths(-4, 20)) : random_.vertex();
        const auto colours = static_cast<unsigned>(random_.below(16));
        const auto nearest = expected_nearest(osem::tests::cells_of(grid, colours), {from, from});
        body.point(from);
        body.u8(colours);
        body.u8(nearest.found ? 1 : 0);
        body.u64(nearest.distance);
        body.point(nearest.corner);
        file_.tally().count(on_planes, is_extreme(from));
    }

    // The colour of all cells in an octant no smaller than they are, or grey.
    static Colour colour_in(const DenseGrid& grid, const Octant& octant) {
        std::size_t first = 0;
        while (grid.corner(first) != octant.corner) ++first; // the octant's first cell has its corner
        return grid.uniform_colour(first, std::size_t{1} << (3 * (grid.depth() - octant.level)))
            .value_or(Colour::grey);
    }

    void put_neighbour(Bytes& body, const DenseGrid& grid) {
        const auto level = static_cast<std::uint8_t>(random_.between(0, grid.depth()));
        Octant octant = {{{0, 0, 0}}, level};
        for (std::int32_t& c : octant.corner.at) c = octant.side() * random_.below(1 << level);
        const auto axis = static_cast<unsigned>(random_.below(3));
        const bool high = random_.below(2) != 0;
        Octant beside = octant;
        beside.corner.at[axis] += high ? octant.side() : -octant.side();
        const bool outside = beside.corner.at[axis] < 0 || beside.corner.at[axis] >= root_side;
        if (outside) beside = osem::root_octant;
        Colour colour = outside ? Colour::white : colour_in(grid, beside);
        while (colour != Colour::grey && beside.level > 0 && colour_in(grid, beside.parent()) == colour) {
            beside = beside.parent();
        }
        body.point(octant.corner);
        body.u8(octant.level);
        body.u8(axis);
        body.u8(high ? 1 : 0);
        body.u8(outside ? 1 : 0);
        body.point(beside.corner);
        body.u8(beside.level);
        body.u8(static_cast<std::uint64_t>(colour));
        file_.tally().count(false, outside);
    }

    void put_collision(Bytes& body, const DenseGrid& a, const DenseGrid& b) {
        Point offset = osem::tests::in_units(in_sixteenths(-17, 17));
        const bool on_planes = random_.below(2) == 0;
        for (unsigned axis = 0; axis < 3 && !on_planes; ++axis) offset.at[axis] += random_.between(-1, 1);
        const auto contact = expected_contact(osem::tests::cells_of(a, osem::solid_colours),
                                              osem::tests::cells_of(b, osem::solid_colours), offset);
        body.point(offset);
        body.u8(static_cast<std::uint64_t>(contact));
        file_.tally().count(on_planes, false);
    }

    VectorFile& file_;
    Random random_{24};
};

} // namespace

void write_query(const std::string& folder) {
    VectorFile file(osem::cross::Topic::query);
    Writer writer(file);
    for (const Colour colour : osem::tests::three_colours) {
        writer.add(DenseGrid(1, colour), osem::tests::grid_of(5));
    }
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        const int depth = 1 + static_cast<int>(seed % 3);
        DenseGrid sparse(depth);
        sparse[(seed * 37) % sparse.size()] = seed % 2 == 0 ? Colour::black : Colour::boundary;
        const DenseGrid full = osem::tests::random_grid(depth, 500 + seed, osem::tests::three_colours);
        const DenseGrid other = osem::tests::random_grid(2, 900 + seed, osem::tests::three_colours);
        writer.add(full, other);
        writer.add(sparse, other);
        writer.add(sparse, sparse);
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
