#include "osem/slice.hpp"

#include "tree/masks.hpp"

namespace osem {

namespace {

constexpr unsigned column_axis[3] = {axis_y, axis_x, axis_x};
constexpr unsigned row_axis[3] = {axis_z, axis_z, axis_y};
static_assert(column_axis[axis_x] + row_axis[axis_x] + axis_x == 3, "the three axes, each once");

// The children, of an octant of a level, on the side on which a coordinate lies.
std::uint8_t children_at(unsigned axis, std::int32_t coordinate, int level) {
    const unsigned low = low_children[axis];
    const bool is_high = ((coordinate >> (max_depth - 1 - level)) & 1) != 0;
    return static_cast<std::uint8_t>(is_high ? ~low : low);
}

} // namespace

Status RowWalk::begin(const Octree& tree, const Slice& slice) {
    level_ = -1;
    piece_length_ = 0;
    if (slice.cell < 0 || slice.cell >= root_side) return Status::point_off_root;
    if (slice.level > tree.depth) return Status::level_out_of_range;
    pool_ = tree.pool;
    top_ = tree.top;
    slice_ = slice;
    visited_ = 0;
    return Status::ok;
}

void RowWalk::enter(std::int32_t row) {
    OSEM_ASSERT(row >= 0 && row < rows());
    row_ = row;
    at_ = 0;
    piece_length_ = 0;
    level_ = -1;
    if (slice_.level == 0) {
        piece_colour_ = pixel_of(top_, 0);
        piece_length_ = 1;
        return;
    }
    level_ = 0;
    ++visited_;
    frames_[0] = Frame{top_, in_row(0)};
}

bool RowWalk::next(PixelRun& run) {
    std::int32_t length = piece_length_;
    Colour colour = piece_colour_;
    if (length == 0 && !next_piece(length, colour)) return false;
    run = PixelRun{row_, at_, length, colour};
    while (next_piece(length, colour)) {
        if (colour != run.colour) {
            piece_length_ = length;
            piece_colour_ = colour;
            at_ += run.length;
            return true;
        }
        run.length += length;
    }
    piece_length_ = 0;
    at_ += run.length;
    return true;
}

std::uint8_t RowWalk::in_layer(int level) const { return children_at(slice_.axis, slice_.cell, level); }

std::uint8_t RowWalk::in_row(int level) const {
    const std::int32_t coordinate = row_ << (max_depth - slice_.level);
    return static_cast<std::uint8_t>(in_layer(level) & children_at(row_axis[slice_.axis], coordinate, level));
}

// The row's next leaf or pixel. Of an octant's children two are in the row, and the lower one comes first.
bool RowWalk::next_piece(std::int32_t& length, Colour& colour) {
    while (level_ >= 0) {
        Frame& frame = frames_[level_];
        if (frame.left == 0) {
            --level_;
            continue;
        }
        const unsigned child = lowest(frame.left);
        frame.left = without_lowest(frame.left);
        colour = frame.node.colour(child);
        length = rows() >> (level_ + 1);
        if (colour != Colour::grey) return true;
        const Node& below = pool_->child(frame.node, child);
        if (level_ + 1 == slice_.level) {
            colour = pixel_of(below, slice_.level);
            return true;
        }
        ++visited_;
        ++level_;
        frames_[level_] = Frame{below, in_row(level_)};
    }
    return false;
}

// The colour of a pixel that is the layer's part of a node's octant: the search ends at the second colour.
Colour RowWalk::pixel_of(const Node& node, int level) {
    unsigned seen = 0; // bit c: colour c
    const int base = level;
    ++visited_;
    frames_[level] = Frame{node, in_layer(level)};
    while (level >= base) {
        Frame& frame = frames_[level];
        if (frame.left == 0) {
            --level;
            continue;
        }
        const unsigned child = lowest(frame.left);
        frame.left = without_lowest(frame.left);
        const Colour colour = frame.node.colour(child);
        if (colour == Colour::grey) {
            const Node& below = pool_->child(frame.node, child);
            ++visited_;
            ++level;
            frames_[level] = Frame{below, in_layer(level)};
            continue;
        }
        seen |= 1U << static_cast<unsigned>(colour);
        if ((seen & (seen - 1)) != 0) return Colour::boundary;
    }
    return seen == 1U << static_cast<unsigned>(Colour::white)   ? Colour::white
           : seen == 1U << static_cast<unsigned>(Colour::black) ? Colour::black
                                                                : Colour::boundary;
}

} // namespace osem
