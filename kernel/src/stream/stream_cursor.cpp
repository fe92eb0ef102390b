#include "osem/stream_cursor.hpp"

#include "stream/codes.hpp"
#include "stream/header.hpp"
#include "tree/unaligned.hpp"

namespace osem {

namespace {

bool read_memory(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count) {
    const std::uint8_t* from = static_cast<const std::uint8_t*>(context) + offset;
    const std::uint8_t* const end = from + count;
    constexpr auto size = static_cast<std::ptrdiff_t>(codes_size);
    for (; end - from >= size; from += size, bytes += size) put_word(bytes, codes_at(from, 0));
    while (from != end) *bytes++ = *from++;
    return true;
}

constexpr unsigned read_size = 64;

} // namespace

Source memory_source(const std::uint8_t* bytes, std::size_t size) {
    return Source{read_memory, const_cast<std::uint8_t*>(bytes), size}; // read_memory only reads
}

StreamCheckOutcome check_stream(const Source& source) {
    StreamCheckOutcome outcome = {Status::ok, 0, source};
    outcome.source.checked = false;
    StreamCursor cursor;
    cursor.begin(outcome.source);
    if (!cursor.done()) cursor.skip();
    outcome.status = cursor.status();
    outcome.offset = cursor.offset();
    outcome.source.checked = outcome.status == Status::ok;
    return outcome;
}

StreamCursor::Window& StreamCursor::Window::operator=(const Window& other) {
    if (this == &other) return *this;
    for (unsigned i = 0; i < sizeof buffer; ++i) buffer[i] = other.buffer[i];
    bytes = other.bytes == other.buffer ? buffer : other.bytes;
    return *this;
}

Status StreamCursor::begin(const Source& source) {
    source_ = source;
    header_ = StreamHeader{};
    path_.begin(1, 0); // before the root: a header that is refused has no other
    level_ = 0;
    checksum_ = Checksum();
    at_ = 0;
    limit_ = 0;
    filled_ = 0;
    window_.bytes = window_.buffer;
    to_come_ = 0;
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
    arrive();
    return status_;
}

// Leaves the byte of a fault in offset_.
Status StreamCursor::read_header() {
    const auto there =
        static_cast<std::size_t>(source_.size < stream_header_size ? source_.size : stream_header_size);
    if (there != 0 && !source_.read(source_.context, 0, window_.buffer, there)) return Status::source_failed;
    for (offset_ = 0; offset_ < there; ++offset_) {
        const auto at = static_cast<std::size_t>(offset_);
        if (!begins_header(at, window_.buffer[at])) return Status::stream_not_osem;
    }
    if (there < stream_header_size) return Status::stream_truncated;
    const HeaderOutcome outcome = decode_header(window_.buffer);
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

// Reads on, keeping what is left; or looks at what lies in memory.
bool StreamCursor::load() {
    const std::uint64_t end = source_.size - stream_trailer_size;
    if (source_.checked && source_.read == read_memory && look_in_place()) return true;
    const std::uint8_t* const from = bytes();
    unsigned kept = 0;
    for (unsigned i = at_ / 4; i < filled_; ++i) window_.buffer[kept++] = from[i];
    window_.bytes = window_.buffer;
    const std::uint64_t left = end - loaded_;
    const unsigned count = left < read_size ? static_cast<unsigned>(left) : read_size;
    at_ %= 4;
    filled_ = kept;
    if (!source_.read(source_.context, loaded_, window_.buffer + kept, count)) {
        fail(Status::source_failed, loaded_);
        return false;
    }
    if (!source_.checked) checksum_.append(window_.buffer + kept, count);
    filled_ += count;
    loaded_ += count;
    limit_ = 4 * filled_ + 1 - (loaded_ == end ? 0 : codes_ahead);
    return true;
}

// Where the source is memory its bytes take the place of the buffer, but for the last ones, behind which a
// look ahead would touch what is not the source's. False where there are only such.
bool StreamCursor::look_in_place() {
    constexpr std::uint64_t most = 1U << 28;
    const std::uint64_t first = loaded_ - filled_ + at_ / 4;
    const std::uint64_t there = source_.size - first;
    if (there < read_size + bytes_behind) return false;
    const std::uint64_t count = there - bytes_behind;
    window_.bytes = static_cast<const std::uint8_t*>(source_.context) + first;
    // unreachable: that there are more, by a test that must do with less memory.
    filled_ = static_cast<unsigned>(count < most ? count : most);
    loaded_ = first + filled_;
    at_ %= 4;
    limit_ = 4 * filled_ + 1 - codes_ahead;
    return true;
}

// Takes the next octant's code. While the path is not whole there is one: as many grey octants as the header
// says have eight codes each in the payload, and more are refused.
void StreamCursor::arrive() {
    if (!is_ready()) return;
    colour_ = static_cast<Colour>(std::uint32_t{bytes()[at_ / 4]} >> (2 * (at_ % 4)) & 3U);
    level_ = static_cast<std::uint8_t>(path_.level());
    ++at_;
    const Status status = path_.take(colour_);
    if (status != Status::ok) fail(status, byte_of(at_ - 1));
}

void StreamCursor::next() { path_.whole() ? end() : arrive(); }

// Back before the octant at which it stands, which next() will meet again.
void StreamCursor::step_back() {
    --at_;
    path_.level_ = level_;
    if (colour_ == Colour::grey) ++path_.nodes_left_;
    if (++path_.left_[level_] != 8) return;
    const auto children = static_cast<std::uint16_t>(codes_at(bytes(), 2 * at_));
    path_.look_ahead(children, is_one_leaf(children));
}

bool StreamCursor::leaf_children(std::uint16_t& codes) const {
    if (colour_ != Colour::grey) return false;
    codes = static_cast<std::uint16_t>(codes_at(bytes(), 2 * at_));
    return grey_codes(codes) == 0 && !is_one_leaf(codes);
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

// Goes on below the octant of level `floor`, by what is in the buffer and at most `most` grey octants; by one
// or to the end of that octant in any case. Precondition: it is open. The codes that went by are only there
// if they are to be read.
StreamCursor::Passage StreamCursor::pass(int floor, std::uint32_t most, bool read) {
    Passage passage = {bytes(), at_, 0, 0};
    if (source_.checked) {
        passage = pass_checked(most, read, may_jump(read) ? path_.to_come(floor) : 0);
        path_.nodes_left_ -= passage.nodes;
        if (!done_ && to_come_ == 0) path_.leave();
        return passage;
    }
    if (!is_ready()) return passage;
    passage = {bytes(), at_, 0, path_.nodes_left_};
    const Status status = path_.take_buffered(passage.bytes, at_, limit_, floor, most);
    if (status != Status::ok) fail(status, byte_of(at_ - 1));
    passage.codes = at_ - passage.at;
    passage.nodes -= path_.nodes_left_;
    return passage;
}

void StreamCursor::skip() {
    if (colour_ == Colour::grey) {
        while (!done_ && path_.level() > level_) pass(level_, UINT32_MAX, false);
    }
    if (!done_) next();
}

// Ends a walk whose path has not been followed, as nothing can be wrong.
void StreamCursor::end_checked() {
    path_.begin(1, 0);
    path_.left_[0] = 0;
    end();
}

// Behind the last octant: the bits that are left (8n + 1 codes end with the first of a byte), and the
// checksum.
void StreamCursor::end() {
    // A walk that looks ahead leaves it to this place.
    if (path_.nodes_left_ != 0) return fail(Status::stream_count_mismatch, byte_of(at_ - 1));
    if ((bytes()[at_ / 4] >> 2) != 0) return fail(Status::stream_payload_damaged, byte_of(at_));
    std::uint8_t bytes[stream_trailer_size];
    if (!source_.read(source_.context, loaded_, bytes, sizeof bytes)) {
        return fail(Status::source_failed, loaded_);
    }
    const auto checksum = get_number<std::uint32_t>(bytes);
    if (source_.checked) {
        checksum_ = Checksum(checksum);
    } else if (checksum != checksum_.value()) {
        return fail(Status::stream_payload_damaged, loaded_);
    }
    offset_ = source_.size;
    done_ = true;
}

} // namespace osem
