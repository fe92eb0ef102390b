#include "osem/preorder_path.hpp"

#include "stream/codes.hpp"

namespace osem {

void PreorderPath::begin(int depth, std::uint32_t nodes) {
    nodes_left_ = nodes;
    depth_ = static_cast<std::uint8_t>(depth);
    level_ = 0;
    alike_ = false;
    left_[0] = 1;
}

Status PreorderPath::take(Colour code) {
    const bool first = left_[level_] == 8;
    if (code == Colour::grey) {
        if (level_ >= depth_) return Status::stream_too_deep;
        if (nodes_left_ == 0) return Status::stream_count_mismatch;
        --nodes_left_;
        --left_[level_];
        left_[++level_] = 8;
        return Status::ok;
    }
    alike_ = first || (alike_ && code == colour_);
    colour_ = code;
    --left_[level_];
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

// Takes the codes below the octants open at level `floor`, as far as at most `most` of them are grey and they
// begin before `limit`: a turn takes 16 codes at most. Leaves `at` behind the last one taken. What
// lies behind the payload is read as well, but nothing depends on it.
Status PreorderPath::take_buffered(const std::uint8_t* bytes, unsigned& at, unsigned limit, int floor,
                                   std::uint32_t most) {
    const std::uint32_t least = nodes_left_ > most ? nodes_left_ - most : 0;
    std::uint32_t nodes = nodes_left_;
    int level = level_;
    unsigned left = left_[level];
    unsigned code = at;
    Status status = Status::ok;
    while (code < limit) {
        Codes codes = codes_at(bytes, code);
        const unsigned run = leaf_run(static_cast<unsigned>(codes), left);
        if (run == left) {
            code += left;
            if (left == 8 && is_one_leaf(static_cast<std::uint16_t>(codes))) {
                status = Status::stream_not_canonical;
                break;
            }
            left = left_[--level];
            if (level == floor) break;
            continue;
        }
        if (nodes == least || level >= depth_) {
            if (nodes != 0 && level < depth_) break;
            code += run + 1;
            status = level >= depth_ ? Status::stream_too_deep : Status::stream_count_mismatch;
            break;
        }
        --nodes;
        code += run + 1;
        left -= run + 1;
        codes = codes_size == 8 ? codes >> (2 * run + 2) : codes_at(bytes, code);
        if (grey_codes(static_cast<unsigned>(codes)) == 0) { // eight leaves
            code += 8;
            if (is_one_leaf(static_cast<std::uint16_t>(codes))) {
                status = Status::stream_not_canonical;
                break;
            }
        } else {
            left_[level++] = static_cast<std::uint8_t>(left);
            left = 8;
        }
    }
    at = code;
    nodes_left_ = nodes;
    level_ = static_cast<std::uint8_t>(level);
    left_[level] = static_cast<std::uint8_t>(left);
    alike_ = false;
    return status != Status::ok || level > floor ? status : ascend();
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

} // namespace osem
