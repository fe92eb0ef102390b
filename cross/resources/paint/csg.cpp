// Expressions over solids, trees and streams.
#include "paint/paint.hpp"
#include "sphere.hpp"

namespace osem::cross {

namespace {

constexpr Sphere sphere(Point{{560000, 480000, 520000}}, 350000);

CsgConversion conversion;
std::uint32_t faces[Sphere::triangle_count];
std::uint8_t stream[40000];
std::size_t stream_length = 0;

bool to_memory(void*, const std::uint8_t* bytes, std::size_t length) {
    if (length > sizeof stream - stream_length) return false;
    for (std::size_t i = 0; i < length; ++i) stream[stream_length++] = bytes[i];
    return true;
}

// The sphere, or what both trees have in common, less a part of the sphere.
constexpr CsgToken tokens[] = {CsgToken::of(0U),
                               CsgToken::of(1U),
                               CsgToken::of(2U),
                               CsgToken::of(Operator::intersect),
                               CsgToken::of(Operator::unite),
                               CsgToken::of(0U),
                               CsgToken::of(2U),
                               CsgToken::of(Operator::exclusive_or),
                               CsgToken::complement(),
                               CsgToken::of(Operator::subtract)};
constexpr std::uint32_t token_count = sizeof tokens / sizeof *tokens;

void measure_expression() {
    CsgExpression expression;
    std::uint32_t where = 0;
    measured("CsgExpression::begin", [&] { use(expression.begin(tokens, token_count, 3, where)); });
    CsgTerm term = {};
    measured("CsgExpression::evaluate", [&] { term = expression.evaluate(CsgColours{1, 6}); });
    expect(where == token_count && !term.is_known());
}

void measure_face_walk(const CheckedSolid& solid) {
    FaceWalk walk;
    FaceFrame frame = {};
    std::uint32_t met = 0;
    std::int32_t winding = 0;
    measured("FaceWalk::begin", [&] { walk.begin(solid, faces); });
    measured("FaceWalk::select", [&] { met = walk.select(root_octant, walk.face_count()); });
    measured("FaceWalk::winding_of_root", [&] { use(walk.winding_of_root()); });
    expect(met == Sphere::triangle_count);
    frame.open(met, 0);
    measured("FaceWalk::winding_of_child", [&] { winding = walk.winding_of_child(frame, root_octant, 7); });
    expect(winding == 1);
    measured("FaceWalk::winding_at_centre", [&] { winding = walk.winding_at_centre(root_octant, met, 0); });
    expect(winding == 1);
}

void measure_conversion(const CsgOperand* operands, const CsgOptions& options) {
    const std::uint32_t mark = pool.used();
    CsgFault fault = {};
    measured("CsgConversion::begin",
             [&] { fault = conversion.begin(tokens, token_count, operands, 3, options, &pool); });
    expect(fault.status == Status::ok);
    measured("CsgConversion::step", [&] { conversion.step(100); });
    std::uint64_t volume = 0;
    measured("CsgConversion::decided_volume", [&] { volume = conversion.decided_volume(); });
    expect(volume != 0);
    measured("CsgConversion::step", [&] {
        while (conversion.step(1000)) {
        }
    });
    Status status = Status::unfinished;
    measured("CsgConversion::finish", [&] { status = conversion.finish().built.status; });
    expect(status == Status::ok && pool.used() > mark);
    pool.roll_back(mark);
}

} // namespace

void paint_csg(const PaintTrees& trees) {
    const CheckedSolid solid = CheckedSolid::vouched(sphere.solid());
    measure_expression();
    measure_face_walk(solid);
    expect(write_stream(trees.b, StreamHeader{}, Sink{to_memory, nullptr}) == Status::ok);
    CsgSolid of_solid(solid, WindingRule::nonzero, faces, Sphere::triangle_count);
    CsgTree of_tree(trees.a);
    CsgStream of_stream(memory_source(stream, stream_length));
    const CsgOperand operands[] = {of_solid, of_tree, of_stream};
    CsgOptions options = {6, LeafRule::conservative};
    measure_conversion(operands, options);
    options.leaves = LeafRule::centre;
    measure_conversion(operands, options);
    measured("convert_expression", [&] {
        const CsgOutcome outcome =
            convert_expression(conversion, tokens, token_count, operands, 3, options, nullptr);
        use(outcome);
    });
}

} // namespace osem::cross
