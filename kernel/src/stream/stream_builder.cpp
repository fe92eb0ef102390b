#include "osem/stream_builder.hpp"

#include "stream/header.hpp"
#include "stream/siblings.hpp"
#include "tree/unaligned.hpp"

namespace osem {

namespace {

// Words of codes from a bit of the first byte on, or those of the complement. All but the last one are found
// in two words, of which many are shifted side by side; a byte is all that may be read behind the last one.
void copy_words(const std::uint8_t* from, unsigned bit, unsigned count, bool inverted, std::uint8_t* to) {
    const auto put_next = [&](Codes codes) {
        put_word(to, inverted ? complemented(codes) : codes);
        from += codes_size;
        to += codes_size;
    };
    for (; count > 1; --count) {
        put_next(codes_at(from, bit) | codes_at(from + codes_size, 0) << 1 << (codes_bits - 1 - bit));
    }
    put_next(all_codes_at(from, bit));
}

} // namespace

void StreamBuilder::restart() {
    nodes_ = 0;
    word_ = Word{};
    checksum_ = Checksum();
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
    header_ = header;
    std::uint8_t bytes[stream_header_size] = {};
    if (sink_.replace == nullptr) encode_header(header, bytes);
    write(bytes, sizeof bytes);
}

void StreamBuilder::open() {
    OSEM_ASSERT(!whole_ && level_ < max_depth);
    children_[level_++] = 0;
}

void StreamBuilder::leaf(Colour colour) {
    OSEM_ASSERT(!whole_ && colour != Colour::grey);
    if (has_leaf_ && colour != colour_) {
        int grey = level_; // octants that hold no leaf yet can still become one of this colour
        while (children_[grey - 1] == 0) --grey;
        flush_pending(grey);
    }
    colour_ = colour;
    while (pending_ < level_) {
        has_leaf_ = true;
        if (++children_[level_ - 1] < 8) return;
        --level_; // eight leaves of one colour: the octant is such a leaf itself
    }
    has_leaf_ = false;
    put(static_cast<std::uint32_t>(colour), 1);
    end_child();
}

void StreamBuilder::leaves(std::uint16_t codes) {
    if (is_one_leaf(codes)) return leaf(static_cast<Colour>(codes & 3U));
    OSEM_ASSERT(!whole_ && level_ < max_depth);
    flush_pending(level_);
    ++nodes_;
    put(static_cast<std::uint32_t>(Colour::grey) | std::uint32_t{codes} << 2, 9);
    end_child();
}

// The octants kept back turn out to be grey, those above level `end`.
void StreamBuilder::flush_pending(int end) {
    if (pending_ >= end) return;
    constexpr auto grey = static_cast<std::uint32_t>(Colour::grey);
    const std::uint32_t leaves = 0x5555U * (static_cast<std::uint32_t>(colour_) & 3U);
    for (; pending_ < end; ++pending_) {
        ++nodes_;
        const unsigned count = children_[pending_] + 1U;
        put((grey | leaves << 2) & ((1U << (2 * count)) - 1U), count);
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

// The children to come of the open octants, behind the next one: of each but those complete and the one that
// is open or next.
std::uint32_t StreamBuilder::behind_next() const {
    std::uint32_t sum = 0;
    for (int i = 0; i < level_; ++i) sum += 7U - children_[i];
    return sum;
}

// The cells of what is complete.
std::uint64_t StreamBuilder::volume() const {
    if (whole_) return root_volume;
    std::uint64_t cells = 0;
    for (int i = 0; i < level_; ++i) cells += children_[i] * volume_at(i + 1);
    return cells;
}

// The next octant is grey, and what is below it comes as the codes of a canonical tree.
void StreamBuilder::begin_copy() {
    OSEM_ASSERT(!whole_ && level_ < max_depth);
    flush_pending(level_);
    ++nodes_;
    put(static_cast<std::uint32_t>(Colour::grey), 1);
}

// `count` codes from number `at` on, `nodes` of them grey; or those of the complement. The unit begun is
// filled first: so all others begin words of what is copied, whichever bit those begin at.
void StreamBuilder::copy(const std::uint8_t* bytes, unsigned at, unsigned count, std::uint32_t nodes,
                         bool inverted) {
    nodes_ += nodes;
    if (!writing_) return;
    constexpr unsigned unit = unit_bits / 2;
    if (word_.used != 0) {
        const unsigned begun = unit - word_.used / 2; // codes that it has room for
        const unsigned some = count < begun ? count : begun;
        const Codes codes = all_codes_at(bytes, 2 * at);
        put((inverted ? complemented(codes) : codes) & ((Codes{1} << (2 * some)) - 1), some);
        at += some;
        count -= some;
    }
    while (count != 0) {
        const unsigned room = (piece_size - filled_ + codes_size - 1) / codes_size;
        const unsigned all = (count + codes_count - 1) / codes_count;
        const unsigned words = all < room ? all : room;
        copy_words(bytes + at / 4, 2 * (at % 4), words, inverted, buffer_ + filled_);
        const unsigned some = count < words * codes_count ? count : words * codes_count;
        filled_ += some / unit * (unit / 4);
        word_.used = 2 * (some % unit);
        word_.bits = codes_at(buffer_ + filled_, 0) & ((Codes{1} << word_.used) - 1);
        if (filled_ >= piece_size) write_piece();
        at += some;
        count -= some;
    }
}

// The next codes of a canonical tree that is told by its codes alone: of one grey octant at most. Returns
// whether the sink has taken everything so far.
bool StreamBuilder::put_canonical(std::uint32_t codes, unsigned count) {
    if (grey_codes(codes) != 0) ++nodes_;
    put(codes, count);
    whole_ = true; // as far as it can tell
    return taken_;
}

// The next octant is complete; its parent stands for good.
void StreamBuilder::end_child() {
    if (level_ == 0 || ++children_[level_ - 1] == 8) close_full();
}

void StreamBuilder::put(Codes codes, unsigned count) { put(word_, codes, count); }

// A word is full.
// unreachable: where registers are wide, as bytes go out there; every 32-bit target runs it.
void StreamBuilder::end_word(Codes full) {
    if (!writing_) return;
    put_word(buffer_ + filled_, full);
    filled_ += codes_size;
    if (filled_ == piece_size) write_piece();
}

// In small pieces, so that a sink may be a slow one. What is behind a piece begins the next one.
void StreamBuilder::write_piece() {
    const unsigned count = filled_ < piece_size ? filled_ : piece_size;
    if (writing_) {
        checksum_.append(buffer_, count);
        write(buffer_, count);
    }
    if constexpr (has_wide_registers) put_word(buffer_, codes_at(buffer_ + piece_size, 0));
    filled_ -= count;
}

void StreamBuilder::write(const std::uint8_t* bytes, std::size_t count) {
    if (taken_) taken_ = sink_.write(sink_.context, bytes, count);
}

Status StreamBuilder::finish() {
    if (!whole_) return Status::unfinished;
    if (!writing_) return taken_ ? Status::ok : Status::sink_refused;
    put_word(buffer_ + filled_, word_.bits);
    filled_ += word_.used / 8 + 1; // 8n + 1 codes: the last byte holds one
    write_piece();
    writing_ = false;
    std::uint8_t bytes[stream_header_size];
    put_number(bytes, checksum_.value());
    write(bytes, stream_trailer_size);
    if (taken_ && sink_.replace != nullptr) {
        // unreachable: by a test in reasonable time, as it takes a stream of gigabytes.
        if (nodes_ > UINT32_MAX) return Status::stream_count_mismatch;
        header_.nodes = static_cast<std::uint32_t>(nodes_);
        encode_header(header_, bytes);
        taken_ = sink_.replace(sink_.context, bytes, sizeof bytes);
    }
    return taken_ ? Status::ok : Status::sink_refused;
}

} // namespace osem
