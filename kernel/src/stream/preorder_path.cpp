#include "osem/preorder_path.hpp"

#include "stream/codes.hpp"

namespace osem {

namespace {

constexpr bool wide = has_wide_registers; // they hold the codes of a turn of take_buffered, mostly of two
constexpr unsigned turn_bits = 32;        // seven leaves, a grey octant and its children
constexpr unsigned window_bits = 64 - 6;  // of a wide register: what is there wherever it begins in a byte

} // namespace

void PreorderPath::begin(int depth, std::uint32_t nodes) {
    nodes_left_ = nodes;
    depth_ = static_cast<std::uint8_t>(depth);
    level_ = 0;
    alike_ = false;
    left_[0] = 1;
}

Status PreorderPath::take(Colour code) {
    const bool first = left_[level_] == 8;
    --left_[level_]; // of one that is refused as well: progress counts the octants before it
    if (code == Colour::grey) {
        if (level_ >= depth_) return Status::stream_too_deep;
        if (nodes_left_ == 0) return Status::stream_count_mismatch;
        --nodes_left_;
        left_[++level_] = 8;
        return Status::ok;
    }
    alike_ = first || (alike_ && code == colour_);
    colour_ = code;
    return ascend();
}

Status PreorderPath::take_leaves() {
    left_[level_] = 0;
    alike_ = false;
    return ascend();
}

// Closes what has eight children. An octant of a higher level has a grey child.
Status PreorderPath::ascend() {
    while (left_[level_] == 0 && level_ > 0) {
        if (alike_) return Status::stream_not_canonical;
        --level_;
    }
    if (left_[level_] == 0) return nodes_left_ != 0 ? Status::stream_count_mismatch : Status::ok;
    return Status::ok;
}

// Leaves the octant that was entered last, of which all is known to be well formed.
void PreorderPath::leave() {
    --level_;
    alike_ = false;
    static_cast<void>(ascend());
}

// The level of what is next behind the innermost open octant; 0 behind the root.
int PreorderPath::level_above() const {
    int level = level_ - 1;
    while (level > 0 && left_[level] == 0) --level;
    return level > 0 ? level : 0;
}

// Goes into the grey octant that was taken last, and looks ahead.
void PreorderPath::enter(std::uint32_t children, bool alike) {
    left_[++level_] = 8;
    look_ahead(children, alike);
}

// The codes of the innermost open octant's children, the first one lowest, of which none has been taken: so
// whether they are leaves of one colour is known before they go by.
void PreorderPath::look_ahead(std::uint32_t children, bool alike) {
    alike_ = alike;
    colour_ = static_cast<Colour>(children & 3U);
}

// Closes the innermost open octant, and what is complete with it: all of that may be, as it was looked ahead.
void PreorderPath::close() {
    level_ = static_cast<std::uint8_t>(level_above());
    alike_ = false;
}

// Takes the codes below the octants open at level `floor`, as far as at most `most` of them are grey and they
// begin before `limit`: a turn takes 16 codes at most. Leaves `at` behind the last one taken. What lies
// behind the payload is read as well, but nothing depends on it.
Status PreorderPath::take_buffered(const std::uint8_t* bytes, unsigned& at, unsigned limit, int floor,
                                   std::uint32_t most) {
    const std::uint32_t least = nodes_left_ > most ? nodes_left_ - most : 0;
    const unsigned end = 2 * limit; // bits, as is what follows but for nodes and levels
    const int depth = depth_;
    std::uint32_t nodes = nodes_left_;
    int level = level_;
    unsigned left = 2U * left_[level];
    unsigned bit = 2 * at;
    Codes codes = 0;
    Codes greys = 0;
    unsigned ready = 0;
    bool equal = false; // eight leaves
    while (bit < end) {
        if (!wide || ready < turn_bits) {
            codes = codes_at(bytes, bit);
            greys = grey_codes(codes);
            ready = window_bits;
        }
        unsigned row = leaf_bits(greys, left);
        if (row == left) { // to the end of the octant
            bit += row;
            equal = left == 16 && eight_alike(codes);
            left = 2U * left_[--level];
            if (equal || level == floor) break;
        } else {
            if (nodes == least || level == depth) break;
            --nodes;
            row += 2;
            bit += row;
            left -= row;
            const Codes below = wide ? codes >> row : codes_at(bytes, bit);
            if (eight_leaves(grey_codes(below))) {
                row += 16;
                bit += 16;
                equal = eight_alike(below);
                if (equal) break;
            } else {
                left_[level++] = static_cast<std::uint8_t>(left / 2);
                left = 16;
            }
        }
        if (wide) {
            codes >>= row;
            greys >>= row;
            ready -= row;
        }
    }
    at = bit / 2;
    nodes_left_ = nodes;
    level_ = static_cast<std::uint8_t>(level);
    left_[level] = static_cast<std::uint8_t>(left / 2);
    alike_ = false;
    if (equal) return Status::stream_not_canonical;
    if (level == floor) return ascend();
    if (bit >= end || (nodes != 0 && level < depth)) return Status::ok;
    at += leaf_bits(greys, left) / 2 + 1; // a grey octant that may not be
    return level == depth ? Status::stream_too_deep : Status::stream_count_mismatch;
}

// The octant of a level whose code is the last one taken of that level.
Octant PreorderPath::taken(int level) const {
    Octant octant = root_octant;
    for (int i = 1; i <= level; ++i) octant = octant.child(7U - left_[i]);
    return octant;
}

// The cells before that octant. Where none of a level has been taken yet, it counts as one behind.
std::uint64_t PreorderPath::volume_before(int level) const {
    std::uint64_t cells = 0;
    for (int i = 1; i <= level; ++i) cells += (std::uint64_t{7} - left_[i]) * volume_at(i);
    return cells;
}

// The children to come of the octants open above a level, and of that.
std::uint32_t PreorderPath::to_come(int level) const {
    std::uint32_t sum = 0;
    for (int i = 0; i <= level; ++i) sum += left_[i];
    return sum;
}

} // namespace osem
