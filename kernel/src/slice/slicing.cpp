#include "osem/slice.hpp"

namespace osem {

namespace {

// Sets the bits [start, start + length), the highest bit of a byte being the first.
void set_bits(std::uint8_t* bytes, std::int32_t start, std::int32_t length) {
    const std::int32_t last = start + length - 1;
    const auto from = static_cast<std::uint8_t>(0xffU >> (start % 8));
    const auto to = static_cast<std::uint8_t>(0xffU << (7 - last % 8));
    std::int32_t byte = start / 8;
    if (byte == last / 8) {
        bytes[byte] = static_cast<std::uint8_t>(bytes[byte] | (from & to));
        return;
    }
    bytes[byte] = static_cast<std::uint8_t>(bytes[byte] | from);
    while (++byte < last / 8) bytes[byte] = 0xff;
    bytes[byte] = static_cast<std::uint8_t>(bytes[byte] | to);
}

SliceOutcome outcome_of(Status status, std::int32_t row, const RowWalk& walk) {
    const bool cut = status == Status::ok && row < walk.rows();
    return {cut ? Status::unfinished : status, row, walk.nodes_visited()};
}

} // namespace

Status RunSlicing::begin(const Octree& tree, const Slice& slice, const RunSink& sink) {
    sink_ = sink;
    row_ = 0;
    const Status status = walk_.begin(tree, slice);
    status_ = status == Status::ok ? Status::ok : Status::unfinished;
    return status;
}

bool RunSlicing::step(std::uint32_t rows) {
    for (; status_ == Status::ok && row_ < walk_.rows(); ++row_, --rows) {
        if (rows == 0) return true;
        walk_.enter(row_);
        for (PixelRun run = {}; walk_.next(run);) {
            if (run.colour == Colour::white || sink_.take(sink_.context, run)) continue;
            status_ = Status::sink_refused;
            return false;
        }
    }
    return false;
}

SliceOutcome RunSlicing::finish() {
    const SliceOutcome outcome = outcome_of(status_, row_, walk_);
    status_ = Status::unfinished;
    return outcome;
}

Status BitmapSlicing::begin(const Octree& tree, const Slice& slice, Bits bits, std::uint8_t* buffer,
                            std::size_t buffer_size, const RowSink& sink) {
    sink_ = sink;
    bits_ = bits;
    buffer_ = buffer;
    row_ = 0;
    status_ = Status::unfinished;
    const Status status = walk_.begin(tree, slice);
    if (status != Status::ok) return status;
    used_ = slice_buffer(slice.level, bits);
    if (buffer_size < used_) return Status::scratch_too_small;
    status_ = Status::ok;
    return Status::ok;
}

bool BitmapSlicing::step(std::uint32_t rows) {
    for (; status_ == Status::ok && row_ < walk_.rows(); ++row_, --rows) {
        if (rows == 0) return true;
        draw(row_);
        if (sink_.take(sink_.context, row_, buffer_, used_)) continue;
        status_ = Status::sink_refused;
        return false;
    }
    return false;
}

void BitmapSlicing::draw(std::int32_t row) {
    std::uint8_t* const inner = bits_ == Bits::both ? buffer_ + used_ / 2 : buffer_;
    for (std::size_t i = 0; i < used_; ++i) buffer_[i] = 0;
    walk_.enter(row);
    for (PixelRun run = {}; walk_.next(run);) {
        if (run.colour == Colour::white) continue;
        if (bits_ != Bits::inner) set_bits(buffer_, run.start, run.length);
        if (bits_ != Bits::outer && run.colour == Colour::black) set_bits(inner, run.start, run.length);
    }
}

SliceOutcome BitmapSlicing::finish() {
    const SliceOutcome outcome = outcome_of(status_, row_, walk_);
    status_ = Status::unfinished;
    return outcome;
}

} // namespace osem
