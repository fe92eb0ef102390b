// Trees as bytes.
#include <new>

#include "paint/paint.hpp"

namespace osem::cross {

namespace {

StreamReader reader;
std::uint8_t stream[40000];
std::size_t stream_length = 0;

// A sink without a frame of its own worth speaking of.
bool to_memory(void*, const std::uint8_t* bytes, std::size_t length) {
    if (length > sizeof stream - stream_length) return false;
    for (std::size_t i = 0; i < length; ++i) stream[stream_length++] = bytes[i];
    return true;
}

// A sink that takes nothing, and no stack.
bool to_nowhere(void*, const std::uint8_t*, std::size_t) { return true; }

StreamCursor cursor;
StreamBuilder builder;
StreamCombination combination;

void paint_path() {
    PreorderPath path;
    measured("PreorderPath::begin", [&] { path.begin(1, 1); });
    Status status = Status::ok;
    measured("PreorderPath::take", [&] { status = path.take(Colour::grey); });
    measured("PreorderPath::take_leaves", [&] { status = path.take_leaves(); });
    expect(status == Status::ok && path.whole());
}

void paint_checksum() {
    const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    constexpr std::uint32_t known = 0xcbf43926U; // what the CRC-32 of these is known to be
    TableChecksum checksum;
    measured("TableChecksum::append", [&] { checksum.append(digits, sizeof digits); });
    expect(checksum.value() == known);
    static SparseChecksum sparse;
    measured("SparseChecksum::append", [&] { sparse.append(digits, sizeof digits); });
    std::uint32_t value = 0;
    measured("SparseChecksum::value", [&] { value = sparse.value(); });
    expect(value == known);
}

void paint_cursor(const Source& source) {
    measured("StreamCursor::begin", [&] { use(cursor.begin(source)); });
    std::uint16_t codes = 0;
    measured("StreamCursor::leaf_children", [&] { use(cursor.leaf_children(codes)); });
    measured("StreamCursor::next", [&] { cursor.next(); });
    measured("StreamCursor::next_or_leaves", [&] { cursor.next_or_leaves(); });
    measured("StreamCursor::skip", [&] {
        while (!cursor.done()) cursor.skip();
    });
    expect(cursor.status() == Status::ok);
}

void paint_builder(const Sink& sink) {
    measured("StreamBuilder::begin", [&] { builder.begin(StreamHeader{1, 0, {}, 1}, sink); });
    measured("StreamBuilder::open", [&] { builder.open(); });
    measured("StreamBuilder::leaf", [&] { builder.leaf(Colour::white); });
    measured("StreamBuilder::leaf", [&] { builder.leaf(Colour::black); });
    for (int left = 6; left > 0; --left) builder.leaf(Colour::white);
    measured("StreamBuilder::finish", [&] { use(builder.finish()); });
    builder.begin();
    measured("StreamBuilder::leaves", [&] { builder.leaves(1); });
    expect(builder.whole());
}

void paint_stream_queries(const Source& source, const Octree& tree) {
    const Point last = {{root_side - 1, root_side - 1, root_side - 1}};
    measured("leaf_at", [&] { use(leaf_at(source, last)); });
    measured("measure", [&] { use(measure(source)); });
    measured("digest", [&] { use(digest(source)); });
    measured("same_leaves", [&] { use(same_leaves(source, source)); });
    measured("same_leaves", [&] { use(same_leaves(source, tree)); });
}

void paint_stream_booleans(const Source& source, const Sink& sink) {
    measured("StreamCombination::begin",
             [&] { use(combination.begin(Operator::exclusive_or, source, source, sink)); });
    measured("StreamCombination::step", [&] {
        while (combination.step(100)) {
        }
    });
    measured("StreamCombination::finish", [&] { use(combination.finish()); });
    measured("StreamCombination::begin_complement", [&] { use(combination.begin_complement(source, sink)); });
    measured("combine", [&] { use(combine(combination, Operator::unite, source, source, sink)); });
    measured("complement", [&] { use(complement(combination, source, sink)); });
}

} // namespace

void paint_streams(const PaintTrees& trees) {
    const Octree& tree = trees.a;
    expect(write_stream(tree, StreamHeader{}, Sink{to_memory, nullptr}) == Status::ok);
    const StreamHeader header = {};
    const Sink sink = {to_nowhere, nullptr};
    measured("write_stream", [&] { use(write_stream(tree, header, sink)); });
    measured("StreamReader::begin", [&] { reader.begin(&other_pool); });
    measured("StreamReader::feed", [&] { reader.feed(stream, stream_length); });
    StreamOutcome outcome = {};
    measured("StreamReader::finish", [&] { outcome = reader.finish(); });
    expect(outcome.built.status == Status::ok && same_leaves(outcome.built.tree, tree));
    // The result is its caller's: made in place, so that no copy of it is measured.
    alignas(Source) static unsigned char source_memory[sizeof(Source)];
    measured("memory_source", [&] { new (source_memory) Source(memory_source(stream, stream_length)); });
    const Source source = memory_source(stream, stream_length);
    alignas(StreamCheckOutcome) static unsigned char outcome_memory[sizeof(StreamCheckOutcome)];
    measured("check_stream", [&] { new (outcome_memory) StreamCheckOutcome(check_stream(source)); });
    static std::uint8_t index[subtree_index_size(1000)];
    measured("check_stream",
             [&] { new (outcome_memory) StreamCheckOutcome(check_stream(source, index, sizeof index)); });
    paint_path();
    paint_checksum();
    paint_cursor(source);
    paint_builder(sink);
    paint_stream_queries(source, tree);
    paint_stream_booleans(source, sink);
}

} // namespace osem::cross
