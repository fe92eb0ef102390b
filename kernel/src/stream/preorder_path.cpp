#include "osem/preorder_path.hpp"

namespace osem {

void PreorderPath::begin(int depth, std::uint32_t nodes) {
    nodes_left_ = nodes;
    level_ = 0;
    depth_ = static_cast<std::uint8_t>(depth);
    whole_ = false;
}

Status PreorderPath::take(Colour code) {
    if (code == Colour::grey) {
        if (level_ >= depth_) return Status::stream_too_deep;
        if (nodes_left_ == 0) return Status::stream_count_mismatch;
        --nodes_left_;
    }
    if (level_ > 0) {
        Group& group = groups_[level_ - 1];
        group.codes =
            static_cast<std::uint16_t>(group.codes | static_cast<unsigned>(code) << (2 * group.child));
        ++group.child;
    }
    if (code != Colour::grey) return ascend();
    groups_[level_++] = Group{0, 0};
    return Status::ok;
}

Status PreorderPath::take_leaves() {
    --level_;
    return ascend();
}

Status PreorderPath::ascend() {
    while (level_ > 0 && groups_[level_ - 1].child == 8) {
        if (is_one_leaf(groups_[level_ - 1].codes)) {
            return Status::stream_not_canonical;
        }
        --level_;
    }
    whole_ = level_ == 0;
    return whole_ && nodes_left_ != 0 ? Status::stream_count_mismatch : Status::ok;
}

} // namespace osem
