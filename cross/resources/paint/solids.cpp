// Check, classification, conversion and the way to the lattice.
#include "paint/paint.hpp"
#include "plate.hpp"
#include "sphere.hpp"

namespace osem::cross {

namespace {

constexpr Sphere sphere(Point{{450000, 500000, 500000}}, 380000);
constexpr Sphere shifted(Point{{600000, 560000, 540000}}, 380000);

StaticNodePool<20> small_pool;
Conversion conversion;
GridConversion grid_conversion;
Edge edges[Sphere::corner_count];
std::uint32_t faces[Sphere::triangle_count];
constexpr std::uint32_t word_count = 8000;
std::uint32_t words[word_count];

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

void measure_grid_conversion(const Solid& solid) {
    const CheckedSolid checked = CheckedSolid::vouched(solid);
    const std::uint32_t mark = pool.used();
    measured("convert", [&] {
        const TreeOutcome a = convert(grid_conversion, checked, conservative, words, word_count, &pool);
        use(a);
    });
    expect(pool.used() > mark);
    pool.roll_back(mark);
    measured("GridConversion::begin",
             [&] { use(grid_conversion.begin(checked, centre, words, word_count, &pool)); });
    measured("GridConversion::step", [&] { grid_conversion.step(100); });
    std::uint64_t volume = 0;
    measured("GridConversion::decided_volume", [&] { volume = grid_conversion.decided_volume(); });
    expect(volume != 0);
    measured("GridConversion::step", [&] {
        while (grid_conversion.step(1000)) {
        }
    });
    measured("GridConversion::finish", [&] {
        const TreeOutcome outcome = grid_conversion.finish();
        use(outcome);
    });
    pool.roll_back(mark);
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

} // namespace

PaintTrees paint_solids() {
    measure_solids();
    measure_classify();
    measure_conversion(sphere.solid());
    measure_conversion(plate);
    measure_grid_conversion(sphere.solid());
    measure_grid_conversion(plate);
    measure_frame();
    const TreeOutcome a = converted(sphere.solid(), conservative);
    const TreeOutcome b = converted(shifted.solid(), conservative);
    expect(a.status == Status::ok && b.status == Status::ok);
    return {a.tree, b.tree};
}

} // namespace osem::cross
