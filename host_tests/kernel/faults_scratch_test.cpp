// Whatever takes scratch, with scratch of every size that is too small: refused as documented, with nothing
// written behind it and the pool as before; and right with the size that its equation states. Blocks of a
// labelling are in bintree_test.cpp, lists and rows of grids in grid_convert_test.cpp.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "osem/bintree.hpp"
#include "osem/boundary.hpp"
#include "osem/components.hpp"
#include "osem/csg.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"
#include "osem/slice.hpp"
#include "support/cell_measures.hpp"
#include "support/dense_grid.hpp"
#include "support/effort.hpp"
#include "support/heap_pool.hpp"
#include "support/slices.hpp"
#include "support/small_solids.hpp"
#include "support/surface.hpp"

namespace osem::tests {

namespace {

// Scratch of some size with a margin behind it that nobody may write to.
template <class T>
class Guarded {
  public:
    explicit Guarded(std::uint32_t size) : size_(size), bytes_(size * sizeof(T) + margin, filler) {
        void* start = bytes_.data();
        std::size_t space = bytes_.size();
        data_ = static_cast<T*>(std::align(alignof(T), size * sizeof(T), start, space));
        EXPECT_NE(data_, nullptr);
    }
    ~Guarded() {
        const auto* behind = reinterpret_cast<const unsigned char*>(data_ + size_);
        for (; behind != bytes_.data() + bytes_.size(); ++behind) EXPECT_EQ(*behind, filler);
    }
    Guarded(const Guarded&) = delete;
    Guarded& operator=(const Guarded&) = delete;
    T* data() { return data_; }
    std::uint32_t size() const { return size_; }

  private:
    static constexpr std::size_t margin = 64;
    static constexpr unsigned char filler = 0xa5;
    std::uint32_t size_;
    std::vector<unsigned char> bytes_;
    T* data_ = nullptr;
};
using GuardedWords = Guarded<std::uint32_t>;

// A run answers with the status for this much scratch, and has looked at the result itself if that is ok.
struct ScratchJob {
    std::string name;
    std::uint32_t needed;
    std::function<Status(std::uint32_t size, NodePool& pool)> run;
};
void PrintTo(const ScratchJob& job, std::ostream* out) { *out << job.name; }

const std::vector<Box> boxes = {{{{100001, 90003, 220005}}, {{600007, 500009, 400011}}},
                                {{{300001, 200003, 250005}}, {{900007, 700009, 800011}}, -1}};
constexpr int depth = 3;

DenseGrid boxes_grid() {
    return make_grid(depth, [](const Point& p, std::int32_t side) {
        return box_colour(boxes, WindingRule::nonzero, p, side);
    });
}
Status judged(const TreeOutcome& outcome) {
    if (outcome.status == Status::ok) {
        EXPECT_EQ(digest(outcome.tree), expected_digest(boxes_grid()));
    }
    return outcome.status;
}

std::vector<ScratchJob> conversion_jobs() {
    const SmallSolid solid = boxes_solid(boxes);
    const std::uint32_t faces = solid.face_count();
    return {{"check", check_scratch(solid.view()),
             [=](std::uint32_t size, NodePool&) {
                 Guarded<Edge> scratch(size);
                 return check(solid.view(), scratch.data(), size).status;
             }},
            {"convert", faces,
             [=](std::uint32_t size, NodePool& pool) {
                 Conversion job;
                 GuardedWords scratch(size);
                 return judged(convert(job, solid.checked(), {depth}, scratch.data(), size, &pool));
             }},
            {"fit", faces,
             [=](std::uint32_t size, NodePool& pool) {
                 Fitting job;
                 GuardedWords scratch(size);
                 return judged(fit(job, solid.checked(), {depth}, scratch.data(), size, pool).built);
             }},
            {"label_faces", faces,
             [=](std::uint32_t size, NodePool& pool) {
                 Labelling job;
                 GuardedWords scratch(size);
                 GuardedWords blocks(2000);
                 return judged(convert_by_labelling(job, solid.checked(), depth, WindingRule::nonzero,
                                                    scratch.data(), size, blocks.data(), 2000, &pool)
                                   .built);
             }},
            {"expression", faces, [=](std::uint32_t size, NodePool& pool) {
                 CsgConversion job;
                 GuardedWords scratch(size);
                 CsgSolid a(solid.checked(), WindingRule::nonzero, scratch.data(), size);
                 const CsgOperand operand(a);
                 const CsgToken token = CsgToken::of(0U);
                 CsgOptions options;
                 options.depth = depth;
                 const CsgOutcome outcome = convert_expression(job, &token, 1, &operand, 1, options, &pool);
                 EXPECT_EQ(outcome.fault.status, outcome.built.status);
                 EXPECT_EQ(outcome.fault.operand, 0U);
                 return judged(outcome.built);
             }}};
}

// What a grid conversion takes is known when it has run; below that it is refused at the start or on the way.
ScratchJob grid_job(int last_levels, LeafRule leaves) {
    const SmallSolid solid = boxes_solid(boxes);
    const auto run = [=](GridConversion& job, std::uint32_t size, NodePool* pool) {
        GuardedWords scratch(size);
        const Status begun =
            job.begin(solid.checked(), {depth, leaves}, scratch.data(), size, pool, {last_levels});
        if (begun == Status::ok) drive(job, {1});
        const TreeOutcome outcome = job.finish();
        EXPECT_EQ(begun == Status::ok, outcome.status != Status::unfinished);
        if (outcome.status == Status::ok && pool != nullptr) {
            const DenseGrid centres = make_grid(depth, [](const Point& p, std::int32_t side) {
                return box_centre_colour(boxes, WindingRule::nonzero, p, side);
            });
            EXPECT_EQ(digest(outcome.tree),
                      expected_digest(leaves == LeafRule::centre ? centres : boxes_grid()));
        }
        return begun == Status::ok ? outcome.status : begun;
    };
    GridConversion counting;
    const auto most = static_cast<std::uint32_t>(grid_scratch(solid.view(), depth, last_levels));
    EXPECT_EQ(run(counting, most, nullptr), Status::ok);
    return {"grids_of_" + std::to_string(last_levels) + (leaves == LeafRule::centre ? "_centres" : ""),
            counting.scratch_used(), [=](std::uint32_t size, NodePool& pool) {
                GridConversion job;
                return run(job, size, &pool);
            }};
}

DenseGrid tree_grid() { return random_grid(depth, 81, three_colours); }

ScratchJob compaction_job() {
    return {"compact", compact_scratch(700), [](std::uint32_t size, NodePool& pool) {
                // Nodes of no meaning before and behind the tree, as many as make it 700.
                const Octree tree = planted(tree_grid(), pool);
                const Node filler = Node::of(0x12, 0x12, 0);
                NodeIndex first = 0;
                while (pool.used() < 700) pool.append(&filler, 1, first);
                Octree moved = tree;
                GuardedWords scratch(size);
                const Status status = compact(pool, &moved, 1, scratch.data(), size);
                EXPECT_EQ(digest(moved), expected_digest(tree_grid()));
                EXPECT_EQ(pool.used(), status == Status::ok ? preorder_masks(tree_grid()).size() - 1 : 700U);
                if (status != Status::ok) {
                    EXPECT_EQ(moved.top, tree.top);
                }
                pool.roll_back(0);
                return status;
            }};
}

ScratchJob component_job(std::uint8_t colours, Connectivity connectivity) {
    HeapPool pool(2000);
    const Octree tree = planted(tree_grid(), *pool);
    return {"components_" + std::to_string(colours),
            static_cast<std::uint32_t>(component_scratch(measure(tree), colours)),
            [=](std::uint32_t size, NodePool& in) {
                const std::uint32_t mark = in.used();
                const Octree stood = planted(tree_grid(), in);
                GuardedWords scratch(size);
                ComponentLabelling job;
                job.begin(stood, colours, connectivity, scratch.data(), size);
                drive(job, {7});
                const ComponentOutcome outcome = job.finish();
                if (outcome.status == Status::ok) {
                    const CellComponents truth = cell_components(tree_grid(), colours, connectivity);
                    EXPECT_EQ(outcome.components, truth.components.size());
                    for (std::size_t cell = 0; cell < tree_grid().size(); ++cell) {
                        EXPECT_EQ(job.component_of(tree_grid().corner(cell)), truth.labels[cell]);
                    }
                }
                in.roll_back(mark);
                return outcome.status;
            }};
}

ScratchJob boundary_job(SolidPart part) {
    HeapPool pool(2000);
    const Octree tree = planted(tree_grid(), *pool);
    Boundary counting;
    const std::uint32_t needed = Surface(counting, tree, part).counted().sizes.corners;
    return {part == SolidPart::inner ? "inner_boundary" : "outer_boundary", needed,
            [=](std::uint32_t size, NodePool& in) {
                const std::uint32_t mark = in.used();
                const Octree stood = planted(tree_grid(), in);
                Guarded<BoundaryCorner> scratch(size);
                Boundary job;
                job.begin(stood, part, scratch.data(), size);
                drive(job, {3});
                const BoundaryOutcome outcome = job.finish();
                EXPECT_EQ(outcome.sizes.corners, needed);
                EXPECT_EQ(outcome.scratch_missing, needed - size);
                if (outcome.status == Status::ok) {
                    EXPECT_EQ(outcome.sizes.faces, expected_faces(solid_cells(tree_grid(), part)).size());
                }
                in.roll_back(mark);
                return outcome.status;
            }};
}

struct Drawn {
    Bits bits;
    Rows expected;
    std::int32_t rows;
    static bool take(void* context, std::int32_t row, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<Drawn*>(context);
        EXPECT_EQ(row, self.rows++);
        const Row& pixels = self.expected[static_cast<std::size_t>(row)];
        std::vector<std::uint8_t> truth = bits_of(pixels, self.bits == Bits::inner);
        if (self.bits == Bits::both) {
            const std::vector<std::uint8_t> inner = bits_of(pixels, true);
            truth.insert(truth.end(), inner.begin(), inner.end());
        }
        EXPECT_EQ(std::vector<std::uint8_t>(bytes, bytes + count), truth);
        return true;
    }
};

ScratchJob bitmap_job(Bits bits) {
    constexpr int level = 4;
    return {"bitmaps_" + std::to_string(static_cast<int>(bits)),
            static_cast<std::uint32_t>(slice_buffer(level, bits)), [=](std::uint32_t size, NodePool& pool) {
                const std::uint32_t mark = pool.used();
                const DenseGrid grid = random_grid(level, 82, three_colours);
                const Octree tree = planted(grid, pool);
                const Slice slice = {axis_y, 3 * root_side / 16 + 5, level};
                Drawn drawn = {bits, expected_rows(grid, slice), 0};
                Guarded<std::uint8_t> buffer(size);
                BitmapSlicing job;
                const Status begun =
                    job.begin(tree, slice, bits, buffer.data(), size, RowSink{Drawn::take, &drawn});
                drive(job, {2});
                EXPECT_EQ(job.finish().status, begun == Status::ok ? Status::ok : Status::unfinished);
                EXPECT_EQ(drawn.rows, begun == Status::ok ? 1 << level : 0);
                pool.roll_back(mark);
                return begun;
            }};
}

std::vector<ScratchJob> scratch_jobs() {
    std::vector<ScratchJob> jobs = conversion_jobs();
    for (const int last : {1, 2, 3}) {
        jobs.push_back(grid_job(last, LeafRule::conservative));
        jobs.push_back(grid_job(last, LeafRule::centre));
    }
    jobs.push_back(compaction_job());
    for (const std::uint8_t colours : {inner_solid, outer_solid, outer_void}) {
        jobs.push_back(component_job(colours, Connectivity::edges));
    }
    for (const SolidPart part : {SolidPart::inner, SolidPart::outer}) jobs.push_back(boundary_job(part));
    for (const Bits bits : {Bits::outer, Bits::inner, Bits::both}) jobs.push_back(bitmap_job(bits));
    return jobs;
}

class ScratchFaults : public ::testing::TestWithParam<ScratchJob> {};

TEST_P(ScratchFaults, EverySizeTooSmallIsRefusedAndTheStatedOneIsEnough) {
    const ScratchJob& of = GetParam();
    HeapPool pool(2000);
    const PoolImage before(pool);
    ASSERT_GT(of.needed, 1U);
    for (std::uint32_t size = 0; size < of.needed; ++size) {
        ASSERT_EQ(of.run(size, *pool), Status::scratch_too_small) << size << " of " << of.needed;
        ASSERT_TRUE(before.same_nodes(pool)) << size;
    }
    EXPECT_EQ(of.run(of.needed, *pool), Status::ok);
}

INSTANTIATE_TEST_SUITE_P(All, ScratchFaults, ::testing::ValuesIn(scratch_jobs()),
                         [](const auto& job) { return job.param.name; });

} // namespace

} // namespace osem::tests
