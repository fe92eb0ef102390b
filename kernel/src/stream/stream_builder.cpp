#include "osem/stream_builder.hpp"

#include "osem/preorder_path.hpp"
#include "stream/crc.hpp"
#include "stream/header.hpp"

namespace osem {

void StreamBuilder::restart() {
    nodes_ = 0;
    bits_ = 0;
    crc_ = 0;
    used_ = 0;
    filled_ = 0;
    level_ = 0;
    pending_ = 0;
    has_leaf_ = false;
    taken_ = true;
    whole_ = false;
}

void StreamBuilder::begin() {
    restart();
    writing_ = false;
}

void StreamBuilder::begin(const StreamHeader& header, const Sink& sink) {
    restart();
    writing_ = true;
    sink_ = sink;
    std::uint8_t bytes[stream_header_size];
    encode_header(header, bytes);
    taken_ = sink_.write(sink_.context, bytes, sizeof bytes);
}

void StreamBuilder::open() {
    OSEM_ASSERT(!whole_ && level_ < max_depth);
    children_[level_++] = 0;
}

void StreamBuilder::leaf(Colour colour) {
    OSEM_ASSERT(!whole_ && colour != Colour::grey);
    if (has_leaf_ && colour != colour_) flush_pending();
    colour_ = colour;
    while (pending_ < level_) {
        has_leaf_ = true;
        if (++children_[level_ - 1] < 8) return;
        --level_; // eight leaves of one colour: the octant is such a leaf itself
    }
    has_leaf_ = false;
    put(static_cast<std::uint32_t>(colour), 1);
    if (level_ > 0) ++children_[level_ - 1];
    close_full();
}

void StreamBuilder::leaves(std::uint16_t codes) {
    if (is_one_leaf(codes)) return leaf(static_cast<Colour>(codes & 3U));
    open();
    flush_pending();
    put(codes, 8);
    children_[level_ - 1] = 8;
    close_full();
}

// The octants kept back turn out to be grey.
void StreamBuilder::flush_pending() {
    const std::uint32_t leaves = 0x5555U * (static_cast<std::uint32_t>(colour_) & 3U);
    for (; pending_ < level_; ++pending_) {
        ++nodes_;
        put(static_cast<std::uint32_t>(Colour::grey), 1);
        const unsigned count = children_[pending_];
        put(leaves & ((1U << (2 * count)) - 1U), count);
    }
    has_leaf_ = false;
}

// Closes what has eight children; nothing is kept back here.
void StreamBuilder::close_full() {
    while (level_ > 0 && children_[level_ - 1] == 8) {
        if (--level_ > 0) ++children_[level_ - 1];
    }
    pending_ = level_;
    whole_ = level_ == 0;
}

void StreamBuilder::put(std::uint32_t codes, unsigned count) {
    if (!writing_) return;
    bits_ |= codes << used_;
    used_ += 2 * count;
    for (; used_ >= 8; used_ -= 8, bits_ >>= 8) put_byte(static_cast<std::uint8_t>(bits_));
}

void StreamBuilder::put_byte(std::uint8_t byte) {
    buffer_[filled_++] = byte;
    if (filled_ == sizeof buffer_) write_buffer();
}

// In small pieces, so that a sink may be a slow one.
void StreamBuilder::write_buffer() {
    crc_ = crc_append(crc_, buffer_, filled_);
    if (taken_ && filled_ != 0) taken_ = sink_.write(sink_.context, buffer_, filled_);
    filled_ = 0;
}

Status StreamBuilder::finish() {
    if (!whole_) return Status::unfinished;
    if (!writing_) return Status::ok;
    writing_ = false;
    put_byte(static_cast<std::uint8_t>(bits_)); // 8n + 1 codes: one is left
    write_buffer();
    std::uint8_t bytes[stream_trailer_size];
    put_number(bytes, crc_);
    if (taken_) taken_ = sink_.write(sink_.context, bytes, sizeof bytes);
    return taken_ ? Status::ok : Status::sink_refused;
}

} // namespace osem
