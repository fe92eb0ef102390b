#include "stream/subtree_index.hpp"

#include "osem/stream_cursor.hpp"
#include "stream/codes.hpp"

namespace osem {

// A cursor reads the payload block by block, and the trailer behind it.
bool IndexedReading::read(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count) {
    auto& self = *static_cast<IndexedReading*>(context);
    if (!self.source_.read(self.source_.context, offset, bytes, count)) return false;
    if (offset < stream_header_size) return true;
    const std::uint64_t end = self.source_.size - stream_trailer_size;
    if (offset == end) return true;
    self.add_block(bytes, count);
    return true;
}

// Two bytes at a time, eight codes, of which each grey one ends a row of leaves. A byte by itself is the last
// one, which holds one code: that of a leaf, if this is a stream.
void IndexedReading::add_block(const std::uint8_t* bytes, std::size_t count) {
    std::uint32_t to_come = to_come_;
    std::uint32_t least = to_come;
    const auto take_leaves = [&](unsigned leaves) {
        to_come -= leaves;
        if (to_come < least) least = to_come;
    };
    *next_++ = static_cast<std::uint8_t>(to_come);
    for (; count > 1; count -= 2, bytes += 2) {
        auto greys = static_cast<unsigned>(grey_codes(bytes[0] | static_cast<unsigned>(bytes[1]) << 8));
        unsigned taken = 0;
        for (; greys != 0; greys &= greys - 1) {
            const unsigned grey = lowest_bit(greys) / 2;
            take_leaves(grey - taken);
            to_come += 7;
            taken = grey + 1;
        }
        take_leaves(8 - taken);
    }
    if (count != 0) take_leaves(1);
    *next_++ = static_cast<std::uint8_t>(least);
    to_come_ = to_come;
}

StreamCheckOutcome check_stream(const Source& source, std::uint8_t* index, std::size_t size) {
    const std::uint64_t fixed = stream_header_size + stream_trailer_size;
    if (source.size > fixed && size < subtree_index_size((source.size - fixed) / 2)) {
        StreamCheckOutcome refused = {Status::scratch_too_small, 0, source};
        refused.source.checked = false;
        refused.source.index = nullptr;
        return refused;
    }
    IndexedReading reading(source, index);
    StreamCheckOutcome outcome = check_stream(reading.source());
    const bool checked = outcome.source.checked;
    outcome.source = source;
    outcome.source.checked = checked;
    outcome.source.index = checked ? index : nullptr;
    return outcome;
}

} // namespace osem
