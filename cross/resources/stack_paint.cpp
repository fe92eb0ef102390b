// Measures the stack of every public function on inputs that take it down its deeper paths. Prints
// `stack NAME BYTES` for each; measure.py compares with the bounds. The exit code is 1 when a call does not
// give what it should, so that no path is measured that was not taken.
#include "stack_paint.hpp"

#include <cstdint>

#include "osem/osem.hpp"
#include "plate.hpp"
#include "platform.hpp"
#include "sphere.hpp"

namespace osem::cross {

using port::print;
using port::print_number;

namespace {

constexpr Sphere sphere(Point{{450000, 500000, 500000}}, 380000);
constexpr Sphere shifted(Point{{600000, 560000, 540000}}, 380000);

StaticNodePool<40000> pool;
StaticNodePool<20> small_pool;
StaticNodePool<20000> other_pool;
Conversion conversion;
Combination combination;
StreamReader reader;
TreeBuilder builder;
Edge edges[Sphere::corner_count];
std::uint32_t faces[Sphere::triangle_count];
std::uint32_t marks[compact_scratch(40000)];
std::uint8_t stream[40000];
std::size_t stream_length = 0;
bool good = true;

void expect(bool condition) { good = good && condition; }

template <class Call>
[[gnu::always_inline]] inline void measured(const char* name, Call call) {
    const std::uint32_t bytes = stack_used_by(call);
    expect(bytes != no_paint_left);
    port::print("stack osem::");
    port::print(name);
    port::print(" ");
    port::print_number(bytes);
    port::print("\n");
}

constexpr ConvertOptions options_of(int depth, LeafRule leaves, WindingRule winding) {
    return {depth, leaves, winding};
}
constexpr ConvertOptions conservative = options_of(6, LeafRule::conservative, WindingRule::nonzero);
constexpr ConvertOptions centre = options_of(5, LeafRule::centre, WindingRule::odd);

TreeOutcome converted(const Solid& solid, const ConvertOptions& options) {
    return convert(conversion, CheckedSolid::vouched(solid), options, faces, Sphere::triangle_count, &pool);
}

void measure_solids() {
    Status of_sphere = Status::ok;
    Status of_plate = Status::ok;
    Status unclosed = Status::ok;
    Solid torn = sphere.solid();
    torn.corner_count -= 3;
    torn.face_count -= 1;
    measured("check", [&] {
        const CheckOutcome a = check(sphere.solid(), edges, Sphere::corner_count);
        of_sphere = a.status;
        const CheckOutcome b = check(plate, edges, Sphere::corner_count);
        of_plate = b.status;
        const CheckOutcome c = check(torn, edges, Sphere::corner_count);
        unclosed = c.status;
    });
    expect(of_sphere == Status::ok && of_plate == Status::ok && unclosed == Status::surface_not_closed);
}

// Each face against each octant of a level.
void measure_classify() {
    const CheckedSolid checked = CheckedSolid::vouched(plate);
    std::uint32_t meets = 0;
    measured("classify", [&] {
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const auto part = [](std::uint32_t bits) { return static_cast<std::int32_t>(bits % 16) << 16; };
            const Octant octant = {{{part(i), part(i / 16), part(i / 256)}}, 4};
            for (std::uint32_t face = 0; face < plate.face_count; ++face) {
                const Decision decision = classify(checked, face, octant);
                meets += decision.meets ? 1U : 0U;
            }
        }
    });
    expect(meets != 0);
}

void measure_conversion(const Solid& solid) {
    const CheckedSolid checked = CheckedSolid::vouched(solid);
    measured("convert", [&] {
        const TreeOutcome a =
            convert(conversion, checked, conservative, faces, Sphere::triangle_count, &other_pool);
        use(a);
        const TreeOutcome b =
            convert(conversion, checked, conservative, faces, Sphere::triangle_count, &small_pool);
        use(b);
    });
    expect(small_pool.refused() != 0 && other_pool.used() != 0);
    measured("Conversion::begin",
             [&] { use(conversion.begin(checked, centre, faces, Sphere::triangle_count, &pool)); });
    measured("Conversion::step", [&] { conversion.step(100); });
    std::uint64_t volume = 0;
    measured("Conversion::decided_volume", [&] { volume = conversion.decided_volume(); });
    expect(volume != 0);
    measured("Conversion::step", [&] {
        while (conversion.step(1000)) {
        }
    });
    measured("Conversion::finish", [&] {
        const TreeOutcome outcome = conversion.finish();
        use(outcome);
    });
}

void measure_booleans(const Octree& a, const Octree& b) {
    constexpr Operator operators[] = {Operator::unite, Operator::intersect, Operator::subtract};
    measured("combine", [&] {
        for (const Operator op : operators) {
            const TreeOutcome outcome = combine(combination, op, a, b, pool);
            use(outcome);
        }
    });
    measured("complement", [&] {
        const TreeOutcome outcome = complement(combination, a, pool);
        use(outcome);
    });
    measured("Combination::begin", [&] {
        use(combination.begin(Operator::unite, a, a, pool));
        use(combination.begin(Operator::exclusive_or, a, b, pool));
    });
    measured("Combination::step", [&] { combination.step(50); });
    std::uint64_t volume = 0;
    measured("Combination::decided_volume", [&] { volume = combination.decided_volume(); });
    expect(volume != 0);
    measured("Combination::step", [&] {
        while (combination.step(1000)) {
        }
    });
    measured("Combination::finish", [&] {
        const TreeOutcome outcome = combination.finish();
        use(outcome);
    });
}

void measure_queries(const Octree& tree) {
    measured("leaf_at", [&] {
        for (std::int32_t x = 0; x < root_side; x += 10007) {
            const PointOutcome outcome = leaf_at(tree, {{x, x, x}});
            use(outcome);
        }
    });
    measured("colours_in", [&] {
        for (std::int32_t x = 0; x < root_side - 70000; x += 10007) {
            const BoxOutcome outcome = colours_in(tree, {{{x, x, 0}}, {{x + 70000, x + 1, root_side}}});
            use(outcome);
        }
    });
}

void measure_walks(const Octree& tree) {
    measured("NodeWalk::NodeWalk", [&] {
        const NodeWalk walk(tree);
        use(walk);
    });
    NodeWalk nodes(tree);
    measured("NodeWalk::next", [&] {
        for (int i = 0; i < 1000 && !nodes.done(); ++i) nodes.next();
    });
    measured("NodeWalk::skip", [&] { nodes.skip(); });
    measured("LeafWalk::LeafWalk", [&] {
        const LeafWalk walk(tree);
        use(walk);
    });
    LeafWalk leaves(tree);
    Leaf leaf = {};
    measured("LeafWalk::next", [&] {
        while (leaves.next(leaf)) {
        }
    });
}

void measure_measures(const Octree& a, const Octree& b) {
    measured("measure", [&] {
        const Measures measures = measure(a);
        use(measures);
    });
    std::uint64_t hash = 0;
    measured("digest", [&] { hash = digest(a); });
    bool same = true;
    measured("same_leaves", [&] { same = same_leaves(a, a) && same_leaves(a, b); });
    expect(hash != 0 && !same);
}

// A sink without a frame of its own worth speaking of.
bool to_memory(void*, const std::uint8_t* bytes, std::size_t length) {
    if (length > sizeof stream - stream_length) return false;
    for (std::size_t i = 0; i < length; ++i) stream[stream_length++] = bytes[i];
    return true;
}

// A sink that takes nothing, and no stack.
bool to_nowhere(void*, const std::uint8_t*, std::size_t) { return true; }

void measure_streams(const Octree& tree) {
    expect(write_stream(tree, StreamHeader{}, Sink{to_memory, nullptr}) == Status::ok);
    const StreamHeader header = {};
    const Sink sink = {to_nowhere, nullptr};
    measured("write_stream", [&] { use(write_stream(tree, header, sink)); });
    measured("StreamReader::begin", [&] { reader.begin(&other_pool); });
    measured("StreamReader::feed", [&] { reader.feed(stream, stream_length); });
    StreamOutcome outcome = {};
    measured("StreamReader::finish", [&] { outcome = reader.finish(); });
    expect(outcome.built.status == Status::ok && same_leaves(outcome.built.tree, tree));
}

void measure_pool() {
    constexpr Node nodes[8] = {};
    NodeIndex first = 0;
    const std::uint32_t mark = pool.used();
    measured("NodePool::append", [&] { use(pool.append(nodes, 8, first)); });
    measured("NodePool::roll_back", [&] { pool.roll_back(mark); });
}

void measure_builder() {
    measured("TreeBuilder::begin", [&] { builder.begin(&pool); });
    measured("TreeBuilder::open", [&] { builder.open(1); });
    measured("TreeBuilder::leaves", [&] { builder.leaves(0x55, 0x05); });
    measured("TreeBuilder::leaf", [&] { builder.leaf(6, Colour::black); });
    builder.open(3);
    builder.leaf(2, Colour::black);
    builder.close();
    measured("TreeBuilder::graft", [&] { builder.graft(5, Node::of(0x0f, 0x01, 0)); });
    const Node unlike = Node::of(0x00, 0x28, 0);
    measured("TreeBuilder::close", [&] {
        builder.close(&unlike, &unlike);
        builder.close();
    });
    measured("TreeBuilder::finish", [&] {
        const TreeOutcome outcome = builder.finish(6);
        use(outcome);
    });
    builder.begin(&pool);
    measured("TreeBuilder::abandon", [&] { builder.abandon(); });
}

void measure_compaction(const Octree& a, const Octree& b) {
    Octree trees[2] = {a, b};
    Status status = Status::unfinished;
    measured("compact", [&] { status = compact(pool, trees, 2, marks, compact_scratch(40000)); });
    expect(status == Status::ok);
}

void measure_frame() {
    const Frame rounding = {{-1000, 0, 1000}, -3};
    const WorldPoint world = {{7001, 8002, 9003}};
    Point lattice = {};
    Status status = Status::unfinished;
    measured("to_lattice", [&] {
        const FrameOutcome outcome = to_lattice(rounding, &world, 1, &lattice);
        use(outcome);
    });
    WorldPoint back = {};
    measured("to_world", [&] { status = to_world(rounding, lattice, back); });
    expect(status == Status::ok);
    measured("describe", [&] { use(describe(Status::sink_refused)); });
}

bool measure_all() {
    measure_solids();
    measure_classify();
    measure_conversion(sphere.solid());
    measure_conversion(plate);
    const TreeOutcome a = converted(sphere.solid(), conservative);
    const TreeOutcome b = converted(shifted.solid(), conservative);
    expect(a.status == Status::ok && b.status == Status::ok);
    measure_booleans(a.tree, b.tree);
    measure_queries(a.tree);
    measure_walks(a.tree);
    measure_measures(a.tree, b.tree);
    measure_streams(a.tree);
    measure_pool();
    measure_builder();
    measure_frame();
    measure_compaction(a.tree, b.tree);
    return good;
}

} // namespace

} // namespace osem::cross

int main(int, char**) {
    if (osem::cross::measure_all()) return 0;
    osem::port::print("stack: a call gave a wrong result\n");
    return 1;
}
