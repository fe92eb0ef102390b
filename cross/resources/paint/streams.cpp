// Trees as bytes.
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
}

} // namespace osem::cross
