// Subtrees of checked streams, which go by as a whole: nothing is known of the octants below, and nothing
// need be.
#include "osem/stream_cursor.hpp"
#include "stream/codes.hpp"
#include "stream/subtree_index.hpp"

namespace osem {

namespace {

// Codes that are looked at before an index is.
constexpr unsigned looked_at = IndexedBlock::codes;

// It is enough to follow how many codes are to come, whatever their levels: eight, and eight more for each
// grey one. So behind every eight codes from the first one on a multiple of eight is to come, and it can be
// none only there. Groups of eight are taken side by side, so at times there are more nodes than `most`.
// `to_come` counts groups, and is 0 at first and in the end. Returns how many of the codes are grey.
std::uint32_t take_groups(const std::uint8_t* bytes, unsigned& at, unsigned limit, std::uint32_t most,
                          std::uint32_t& to_come) {
    // In a turn that takes all groups there are so many bytes more in the buffer than behind each code.
    constexpr std::ptrdiff_t more = (8 * CodeGroups::count - codes_ahead) / 4;
    const unsigned in_byte = at % 4; // the place of each group's first code
    const std::uint8_t* const begin = bytes + at / 4;
    const std::uint8_t* const end = bytes + (limit - in_byte + 3) / 4;
    const std::uint8_t* from = begin;
    std::uint32_t nodes = 0;
    std::uint32_t coming = to_come == 0 ? 1 : to_come;
    const auto take = [&](const CodeGroups& groups, unsigned taken) {
        const unsigned greys = groups.greys(taken);
        from += std::size_t{2} * taken;
        nodes += greys;
        coming += greys - taken;
    };
    if constexpr (has_wide_registers) { // nearly every turn takes all groups: those have a loop to themselves
        while (end - from > more && nodes < most && coming != 0) {
            const CodeGroups groups(all_codes_at(from, 2 * in_byte));
            groups.any_ends(coming) ? take(groups, groups.to_end(coming, CodeGroups::count))
                                    : take(groups, CodeGroups::count);
        }
    }
    bool goes_on = from == begin || (coming != 0 && nodes < most && from < end);
    // unreachable: that it goes on where the loop above has left less than two turns take.
    for (; goes_on; goes_on = coming != 0 && nodes < most && from < end) {
        const CodeGroups groups(all_codes_at(from, 2 * in_byte));
        take(groups, groups.to_end(coming, end - from > more ? CodeGroups::count : codes_ahead / 8));
    }
    at = 4 * static_cast<unsigned>(from - bytes) + in_byte;
    to_come = coming;
    return nodes;
}

} // namespace

// Goes on below a grey octant whose children come next, or where the last call has left it, by at most `most`
// grey octants; by one or to the end of that octant in any case. By turns what is in the buffer is looked at
// and an index, if there is one, leads on. `behind` octants are to come behind the subtree.
StreamCursor::Passage StreamCursor::pass_checked(std::uint32_t most, bool read, std::uint32_t behind) {
    const bool jumps = may_jump(read);
    // Most subtrees that are read end before an index need be looked at.
    bool looks = !jumps || (read && to_come_ == 0);
    // What an index leads over need not be loaded.
    // unreachable: that what is read is not ready where an index leads on, as it lies in memory then.
    const bool ready = (jumps && !read) || is_ready();
    Passage passage = {bytes(), at_, 0, 0};
    if (!ready) return passage;
    for (;; looks = !looks) {
        if (looks) {
            if (!is_ready()) return passage;
            const unsigned from = at_;
            const unsigned limit = jumps && limit_ - at_ > looked_at ? at_ + looked_at : limit_;
            passage.nodes += take_groups(bytes(), at_, limit, most - passage.nodes, to_come_);
            passage.codes += at_ - from;
            if (!jumps || to_come_ == 0 || at_ >= limit_) return passage;
        } else {
            jump(behind, most - passage.nodes, passage);
            if (done_) return passage;
        }
        // What has been loaded since is no longer behind that in memory.
        if (bytes() != passage.bytes || passage.nodes >= most) return passage;
    }
}

// Goes on to the first block in which the subtree can end by the index: to the last group of eight codes that
// begins before it, or with it, if there is one. `behind` octants are to come behind the subtree. A
// block has 32 grey codes, and up to 18 more where more is to come behind it than before.
void StreamCursor::jump(std::uint32_t behind, std::uint32_t most, Passage& passage) {
    constexpr std::uint32_t most_blocks = 1U << 20;
    const std::uint32_t blocks = most < 64 ? 1 : most / 32;
    // As many blocks as there can be are numbered by 27 bits.
    const std::uint64_t place = byte_of(at_) - stream_header_size;
    const auto first = static_cast<std::uint32_t>(place / IndexedBlock::bytes);
    const std::uint32_t last = first + (blocks < most_blocks ? blocks : most_blocks);
    std::uint32_t number = first;
    while (number < last && indexed_block(source_.index, number).least > behind) ++number;
    // What is copied may be looked at a word and a byte behind each code.
    const std::uint64_t begin = std::uint64_t{number} * IndexedBlock::bytes + stream_header_size;
    if (number > first && begin + bytes_behind > source_.size) --number;
    const unsigned passed = 4 * static_cast<unsigned>(place % IndexedBlock::bytes) + at_ % 4;
    const unsigned codes_before = IndexedBlock::codes * (number - first);
    if (codes_before < passed + 8) return;
    const unsigned between = (codes_before - passed) % 8;
    const unsigned codes = codes_before - passed - between;
    at_ += codes;
    passage.codes += codes;
    if (at_ >= limit_) { // what is left out is not read
        loaded_ = byte_of(at_);
        filled_ = 0;
        at_ %= 4;
        if (!load()) return;
    }
    const Codes next = codes_at(bytes(), 2 * at_) & ((Codes{1} << (2 * between)) - 1);
    const std::uint32_t to_come =
        indexed_block(source_.index, number).to_come + between - 8 * CodeGroups(next).greys(1) - behind;
    // Each code is one less to come, and a grey one eight more.
    passage.nodes += codes / 8 + to_come / 8 - (to_come_ == 0 ? 1 : to_come_);
    to_come_ = to_come / 8;
}

} // namespace osem
