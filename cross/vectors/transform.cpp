// Trees by their leaves and what becomes of them when they are moved, turned, made coarser and scaled: cells
// of dense grids moved, counted and looked up one by one.
#include <algorithm>

#include "format.hpp"
#include "grid_leaves.hpp"
#include "random.hpp"
#include "support/transforms.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Coarse;
using osem::Octant;
using osem::Placement;
using osem::Status;
using osem::cross::Transform;
using osem::tests::DenseGrid;

constexpr int placements = 6;
constexpr unsigned symmetries = 6;
constexpr int coarsenings = 4;
constexpr int scales = 2;

class Writer {
  public:
    explicit Writer(VectorFile& file) : file_(file) {}

    /// A record of one tree.
    void add(const DenseGrid& grid) {
        cases_ = Bytes();
        most_nodes_ = 0;
        for (int i = 0; i < placements; ++i) place(grid);
        for (unsigned i = 0; i < symmetries; ++i) reorient(grid);
        for (int i = 0; i < coarsenings; ++i) coarsen(grid);
        for (int i = 0; i < scales; ++i) scale(grid);
        Bytes body;
        body.u32(most_nodes_);
        put_grid(body, grid);
        body.u8(placements + symmetries + coarsenings + 2 * scales);
        body.append(cases_);
        file_.add_record(std::move(body));
    }

  private:
    void put_kind(Transform kind) { cases_.u8(static_cast<std::uint64_t>(kind)); }

    void put_refusal(Status status) { cases_.u8(static_cast<std::uint64_t>(status)); }

    void put_result(const DenseGrid& grid) {
        cases_.u8(static_cast<std::uint64_t>(Status::ok));
        put_grid(cases_, grid);
        const osem::tests::Masks masks = osem::tests::preorder_masks(grid);
        cases_.u64(osem::tests::expected_digest(masks));
        most_nodes_ = std::max(most_nodes_, masks.size() - 1);
    }

    Placement random_placement() {
        Placement placement;
        const int bits = random_.between(1, 3);
        placement.by = osem::tests::random_vector(engine_, bits, std::min(1 << bits, 5));
        if (random_.below(2) == 0) placement.keep = osem::tests::random_box(engine_, random_.between(1, 3));
        placement.cut_at_root = random_.below(3) != 0;
        return placement;
    }

    // One in three at a depth of its own, which may be too coarse or, with mixed octants as boundary, not.
    void place(const DenseGrid& grid) {
        Placement placement = random_placement();
        const int exact = exact_depth(grid, placement);
        if (random_.below(3) == 0) placement.depth = static_cast<std::uint8_t>(random_.between(1, exact));
        placement.mixed_as_boundary = random_.below(3) != 0;
        put_kind(Transform::place);
        cases_.point(placement.by);
        cases_.point(placement.keep.low);
        cases_.point(placement.keep.high);
        cases_.u8(placement.cut_at_root ? 1 : 0);
        cases_.u8(placement.depth);
        cases_.u8(placement.mixed_as_boundary ? 1 : 0);
        const int depth = placement.depth == 0 ? exact : placement.depth;
        const bool leaves = !placement.cut_at_root && leaves_root(grid, placement.by);
        if (depth < exact && !placement.mixed_as_boundary) {
            put_refusal(Status::depth_too_coarse);
        } else if (leaves) {
            put_refusal(Status::part_leaves_root);
        } else {
            put_result(coarse(placed(grid, placement, exact), depth, Coarse::certified));
        }
        file_.tally().count(depth < exact, leaves);
    }

    // The 48 symmetries in turn.
    void reorient(const DenseGrid& grid) {
        const osem::Symmetry symmetry = osem::Symmetry::nth(next_symmetry_++ % 48);
        put_kind(Transform::reorient);
        for (const std::uint8_t from : symmetry.from) cases_.u8(from);
        cases_.u8(symmetry.flips);
        put_result(reoriented(grid, symmetry));
        file_.tally().count(false, false);
    }

    void coarsen(const DenseGrid& grid) {
        const int depth = random_.between(1, grid.depth());
        const auto mode = static_cast<Coarse>(next_mode_++ % 4);
        put_kind(Transform::coarsen);
        cases_.u8(static_cast<std::uint64_t>(depth));
        cases_.u8(static_cast<std::uint64_t>(mode));
        put_result(coarse(grid, depth, mode));
        file_.tally().count(depth == grid.depth(), false);
    }

    Octant random_octant(int level) {
        Octant octant = osem::root_octant;
        for (int i = 0; i < level; ++i) octant = octant.child(static_cast<unsigned>(random_.below(8)));
        return octant;
    }

    void put_octant(const Octant& octant) {
        cases_.point(octant.corner);
        cases_.u8(octant.level);
    }

    void scale(const DenseGrid& grid) {
        const Octant up = random_octant(random_.below(grid.depth() + 2));
        put_kind(Transform::enlarge);
        put_octant(up);
        put_result(enlarged_grid(grid, up));
        file_.tally().count(up.level == 0, up.level > grid.depth());
        const Octant down = random_octant(random_.below(3));
        put_kind(Transform::reduce);
        put_octant(down);
        put_result(reduced_grid(grid, down));
        file_.tally().count(down.level == 0, false);
    }

    VectorFile& file_;
    Random random_{31};
    std::mt19937 engine_{32};
    unsigned next_symmetry_ = 0;
    unsigned next_mode_ = 0;
    Bytes cases_;
    std::size_t most_nodes_ = 0;
};

} // namespace

void write_transform(const std::string& folder) {
    VectorFile file(osem::cross::Topic::transform);
    Writer writer(file);
    for (const osem::Colour colour : osem::tests::three_colours) writer.add(DenseGrid(1, colour));
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        const int depth = 1 + static_cast<int>(seed % 3);
        writer.add(osem::tests::random_grid(
            depth, 2000 + seed, seed % 4 == 0 ? osem::tests::two_colours : osem::tests::three_colours));
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
