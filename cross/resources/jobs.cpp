// Counts the instructions of fixed jobs, under QEMU's -icount shift=0. Prints `count NAME INSTRUCTIONS` for
// each; the exit code is 1 when a job does not give what it should.
#include <cstdint>

#include "instruction_clock.hpp"
#include "osem/osem.hpp"
#include "platform.hpp"
#include "sphere.hpp"

namespace osem::cross {

using port::print;
using port::print_number;

namespace {

constexpr int depth = 6; // 64 x 64 x 64 leaves at most
constexpr std::uint32_t query_count = 1000;
constexpr std::uint32_t stream_query_count = 100;
constexpr std::uint32_t block_size = 32768; // words; the job below checks that they suffice
constexpr std::int32_t box_side = root_side / 16;

constexpr Sphere left(Point{{450000, 500000, 500000}}, 380000);
constexpr Sphere right(Point{{600000, 560000, 540000}}, 380000);

StaticNodePool<20000> pool;
StaticNodePool<10000> read_back;
Conversion conversion;
GridConversion grid_conversion;
Labelling labelling;
Combination combination;
StreamReader reader;
Edge edges[Sphere::corner_count];
std::uint32_t faces[Sphere::triangle_count];
std::uint32_t blocks[block_size];
std::uint32_t grid_words[8000];
StreamCombination stream_combination;
Point cells[query_count];

template <class Job>
bool count(const char* name, Job job) {
    cortex_m::start_instruction_clock();
    const bool right_result = job();
    const std::uint64_t instructions = cortex_m::instructions();
    port::print("count ");
    port::print(name);
    port::print(" ");
    port::print_number(instructions);
    port::print(right_result ? "\n" : " with a wrong result\n");
    return right_result;
}

// A stream in memory, whose first bytes can be replaced.
struct StreamMemory {
    std::uint8_t bytes[30000];
    std::size_t length;

    Sink sink() { return Sink{write, this, replace}; }
    Source source() const { return memory_source(bytes, length); }
    StreamCheckOutcome check() const { return check_stream(source()); }
    StreamCheckOutcome check(std::uint8_t* index_of, std::size_t size) const {
        return check_stream(source(), index_of, size);
    }

  private:
    static bool write(void* context, const std::uint8_t* from, std::size_t count) {
        auto& self = *static_cast<StreamMemory*>(context);
        if (count > sizeof self.bytes - self.length) return false;
        for (std::size_t i = 0; i < count; ++i) self.bytes[self.length++] = from[i];
        return true;
    }
    static bool replace(void* context, const std::uint8_t* from, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) static_cast<StreamMemory*>(context)->bytes[i] = from[i];
        return true;
    }
};

StreamMemory stream;
StreamMemory other_stream;
StreamMemory united_stream;
std::uint8_t index[1000];

// Pseudo-random cells from which a box of queries still lies in the root (a linear congruential generator;
// constants of Numerical Recipes).
void choose_cells() {
    std::uint32_t state = 1;
    for (Point& cell : cells) {
        for (std::int32_t& coordinate : cell.at) {
            state = state * 1664525U + 1013904223U;
            coordinate = static_cast<std::int32_t>(state >> 12) % (root_side - box_side);
        }
    }
}

bool point_queries(const Octree& tree) {
    std::uint32_t found = 0;
    for (const Point& cell : cells) {
        if (leaf_at(tree, cell).leaf.colour == Colour::black) ++found;
    }
    return found != 0 && found != query_count;
}

// Each answer is compared with the tree's, which takes a twentieth of the time at most.
bool stream_queries(const Source& source, const Octree& tree) {
    bool same = true;
    for (std::uint32_t i = 0; i < stream_query_count; ++i) {
        const StreamPointOutcome found = leaf_at(source, cells[i]);
        const Leaf expected = leaf_at(tree, cells[i]).leaf;
        same &= found.point.status == Status::ok && found.point.leaf.colour == expected.colour &&
                found.point.leaf.octant.corner == expected.octant.corner;
    }
    return same;
}

bool box_queries(const Octree& tree) {
    std::uint32_t clear = 0;
    for (const Point& cell : cells) {
        const CellBox box = {cell, {{cell.at[0] + box_side, cell.at[1] + box_side, cell.at[2] + box_side}}};
        if (colours_in(tree, box).clear()) ++clear;
    }
    return clear != 0 && clear != query_count;
}

TreeOutcome converted(const Sphere& sphere) {
    ConvertOptions options;
    options.depth = depth;
    return convert(conversion, CheckedSolid::vouched(sphere.solid()), options, faces, Sphere::triangle_count,
                   &pool);
}

// By grids, to the same tree; the pool is left as it was.
bool converted_by_grids(const Octree& same) {
    const std::uint32_t mark = pool.used();
    TreeOutcome outcome = {};
    const bool good = count("convert_grid", [&] {
        ConvertOptions options;
        options.depth = depth;
        outcome =
            convert(grid_conversion, CheckedSolid::vouched(left.solid()), options, grid_words, 8000, &pool);
        return outcome.status == Status::ok;
    });
    const bool right_tree = good && same_leaves(same, outcome.tree);
    pool.roll_back(mark);
    return right_tree;
}

// The other technique, to the same tree; the pool is left as it was.
bool labelled(const Octree& same) {
    const std::uint32_t mark = pool.used();
    LabellingOutcome outcome = {};
    const bool good = count("convert_bintree", [&] {
        outcome =
            convert_by_labelling(labelling, CheckedSolid::vouched(left.solid()), depth, WindingRule::nonzero,
                                 faces, Sphere::triangle_count, blocks, block_size, &pool);
        return outcome.built.status == Status::ok;
    });
    const bool right_tree = good && same_leaves(same, outcome.built.tree);
    pool.roll_back(mark);
    return right_tree;
}

bool stream_jobs(const Octree& tree, const Octree& other, const Octree& both) {
    bool good = count("write_stream",
                      [&] { return write_stream(tree, StreamHeader{}, stream.sink()) == Status::ok; });
    Octree same = Octree::uniform(read_back, Colour::white);
    good &= count("read_stream", [&] {
        reader.begin(&read_back);
        reader.feed(stream.bytes, stream.length);
        const StreamOutcome outcome = reader.finish();
        same = outcome.built.tree;
        return outcome.built.status == Status::ok;
    });
    good &= write_stream(other, StreamHeader{}, other_stream.sink()) == Status::ok;
    good &= count("stream_union", [&] {
        return combine(stream_combination, Operator::unite, stream.source(), other_stream.source(),
                       united_stream.sink())
                   .status == Status::ok;
    });
    good &= same_leaves(united_stream.source(), both).same;
    StreamCheckOutcome checked = {};
    good &= count("check_stream", [&] {
        checked = stream.check();
        return checked.status == Status::ok;
    });
    united_stream.length = 0;
    const StreamCheckOutcome other_checked = other_stream.check();
    good &= count("checked_stream_union", [&] {
        return combine(stream_combination, Operator::unite, checked.source, other_checked.source,
                       united_stream.sink())
                   .status == Status::ok;
    });
    good &= same_leaves(united_stream.source(), both).same;
    good &= count("stream_queries", [&] { return stream_queries(checked.source, tree); });
    good &= count("index_stream", [&] {
        checked = stream.check(index, sizeof index);
        return checked.status == Status::ok;
    });
    good &= count("indexed_stream_queries", [&] { return stream_queries(checked.source, tree); });
    return good && same_leaves(tree, same);
}

bool all_jobs() {
    bool good =
        count("check", [] { return check(left.solid(), edges, Sphere::corner_count).status == Status::ok; });
    good &= check(right.solid(), edges, Sphere::corner_count).status == Status::ok;
    TreeOutcome a = {};
    good &= count("convert", [&] {
        a = converted(left);
        return a.status == Status::ok;
    });
    good &= converted_by_grids(a.tree);
    good &= labelled(a.tree);
    const TreeOutcome b = converted(right);
    TreeOutcome both = {};
    good &= b.status == Status::ok && count("union", [&] {
                both = combine(combination, Operator::unite, a.tree, b.tree, pool);
                return both.status == Status::ok;
            });
    choose_cells();
    good &= count("point_queries", [&] { return point_queries(a.tree); });
    good &= count("box_queries", [&] { return box_queries(a.tree); });
    return stream_jobs(a.tree, b.tree, both.tree) && good;
}

} // namespace

} // namespace osem::cross

int main(int, char**) { return osem::cross::all_jobs() ? 0 : 1; }
