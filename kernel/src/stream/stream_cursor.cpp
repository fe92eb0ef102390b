#include "osem/stream_cursor.hpp"

#include "stream/crc.hpp"
#include "stream/header.hpp"

namespace osem {

namespace {

bool read_memory(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count) {
    const std::uint8_t* from = static_cast<const std::uint8_t*>(context) + offset;
    for (std::size_t i = 0; i < count; ++i) bytes[i] = from[i];
    return true;
}

constexpr unsigned group_bytes = 3; // eight codes lie in three bytes at most

} // namespace

Source memory_source(const std::uint8_t* bytes, std::size_t size) {
    return Source{read_memory, const_cast<std::uint8_t*>(bytes), size}; // read_memory only reads
}

Status StreamCursor::begin(const Source& source) {
    source_ = source;
    header_ = StreamHeader{};
    crc_ = 0;
    at_ = 0;
    filled_ = 0;
    status_ = Status::ok;
    offset_ = 0;
    done_ = false;
    const Status status = read_header();
    if (status != Status::ok) {
        fail(status, offset_);
        return status;
    }
    loaded_ = stream_header_size;
    path_.begin(header_.depth, header_.nodes);
    octant_ = root_octant;
    arrive();
    return status_;
}

// Leaves the byte of a fault in offset_.
Status StreamCursor::read_header() {
    const auto there =
        static_cast<std::size_t>(source_.size < stream_header_size ? source_.size : stream_header_size);
    if (there != 0 && !source_.read(source_.context, 0, buffer_, there)) return Status::source_failed;
    for (offset_ = 0; offset_ < there; ++offset_) {
        const auto at = static_cast<std::size_t>(offset_);
        if (!begins_header(at, buffer_[at])) return Status::stream_not_osem;
    }
    if (there < stream_header_size) return Status::stream_truncated;
    const HeaderOutcome outcome = decode_header(buffer_);
    header_ = outcome.header;
    offset_ = outcome.offset;
    if (outcome.status != Status::ok) return outcome.status;
    const std::uint64_t size = stream_size(header_.nodes);
    offset_ = source_.size < size ? source_.size : size;
    return source_.size < size   ? Status::stream_truncated
           : source_.size > size ? Status::stream_trailing_bytes
                                 : Status::ok;
}

void StreamCursor::fail(Status status, std::uint64_t offset) {
    status_ = status;
    offset_ = offset;
    done_ = true;
}

// Sees to it that the next eight codes, or all that are left, are in the buffer.
bool StreamCursor::load() {
    const unsigned used = at_ / 4;
    const std::uint64_t end = source_.size - stream_trailer_size;
    if (filled_ - used >= group_bytes || loaded_ == end) return true;
    unsigned kept = 0;
    for (unsigned i = used; i < filled_; ++i) buffer_[kept++] = buffer_[i];
    const std::uint64_t left = end - loaded_;
    const unsigned room = static_cast<unsigned>(sizeof buffer_) - kept;
    const unsigned count = left < room ? static_cast<unsigned>(left) : room;
    at_ %= 4;
    filled_ = kept;
    if (!source_.read(source_.context, loaded_, buffer_ + kept, count)) {
        fail(Status::source_failed, loaded_);
        return false;
    }
    crc_ = crc_append(crc_, buffer_ + kept, count);
    filled_ += count;
    loaded_ += count;
    return true;
}

// The byte of the stream that holds a code of the buffer.
std::uint64_t StreamCursor::byte_of(std::uint64_t code) const { return loaded_ - filled_ + code / 4; }

// Takes the next octant's code; octant_ is already that octant. While the path is not whole there is one: as
// many grey octants as the header says have eight codes each in the payload, and more are refused.
void StreamCursor::arrive() {
    if (!load()) return;
    offset_ = byte_of(at_);
    colour_ = static_cast<Colour>(std::uint32_t{buffer_[at_ / 4]} >> (2 * (at_ % 4)) & 3U);
    ++at_;
    const Status status = path_.take(colour_);
    if (status != Status::ok) return fail(status, offset_);
    if (colour_ == Colour::grey) load(); // leaf_children looks ahead
}

void StreamCursor::next() {
    if (path_.whole()) return end();
    const std::int32_t side = root_side >> path_.level();
    const unsigned child = path_.child();
    for (unsigned axis = 0; axis < 3; ++axis) {
        std::int32_t& corner = octant_.corner.at[axis];
        corner &= -2 * side; // the corner of the parent
        if (((child >> axis) & 1U) != 0) corner |= side;
    }
    octant_.level = static_cast<std::uint8_t>(path_.level());
    arrive();
}

bool StreamCursor::leaf_children(std::uint16_t& codes) const {
    if (colour_ != Colour::grey) return false;
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < group_bytes && at_ / 4 + i < filled_; ++i) {
        bits |= static_cast<std::uint32_t>(buffer_[at_ / 4 + i]) << (8 * i);
    }
    codes = static_cast<std::uint16_t>(bits >> (2 * (at_ % 4)));
    const unsigned grey = (static_cast<unsigned>(codes) >> 1) & ~static_cast<unsigned>(codes) & 0x5555U;
    return grey == 0 && !is_one_leaf(codes);
}

void StreamCursor::pass_leaves() {
    at_ += 8;
    const Status status = path_.take_leaves();
    if (status != Status::ok) return fail(status, byte_of(at_ - 1));
    next();
}

void StreamCursor::next_or_leaves() {
    std::uint16_t codes = 0;
    leaf_children(codes) ? pass_leaves() : next();
}

void StreamCursor::skip() {
    const int level = this->level();
    const bool grey = colour_ == Colour::grey;
    next_or_leaves();
    while (grey && !done_ && this->level() > level) next_or_leaves();
}

// Behind the last octant: the bits that are left (8n + 1 codes end with the first of a byte), and the
// checksum.
void StreamCursor::end() {
    if ((buffer_[at_ / 4] >> 2) != 0) {
        return fail(Status::stream_payload_damaged, byte_of(at_));
    }
    std::uint8_t bytes[stream_trailer_size];
    if (!source_.read(source_.context, loaded_, bytes, sizeof bytes)) {
        return fail(Status::source_failed, loaded_);
    }
    if (get_number<std::uint32_t>(bytes) != crc_) return fail(Status::stream_payload_damaged, loaded_);
    offset_ = source_.size;
    done_ = true;
}

} // namespace osem
