#include "osem/fit.hpp"
#include "tree/masks.hpp"

namespace osem {

void Appraisal::begin(const NodePool* pool, const Node& node, int level, std::uint64_t price) {
    pool_ = pool;
    price_ = price;
    black_ = 0;
    top_level_ = level;
    at_ = -1;
    enter(node);
}

void Appraisal::enter(const Node& node) {
    ++at_;
    const std::uint64_t cells = volume_at(top_level_ + at_ + 1);
    const unsigned black = count_bits(blacks(node));
    black_ += black * cells;
    frames_[at_] = Frame{node, node.grey(), (black + count_bits(whites(node))) * cells, 0, 0};
}

bool Appraisal::step() {
    while (frames_[at_].left == 0) {
        if (at_ == 0) return false;
        const Frame& child = frames_[at_];
        const bool given_up = is_given_up(child);
        Frame& parent = frames_[--at_];
        parent.known += child.known;
        parent.cost += given_up ? child.known : price_ + child.cost;
        parent.kept += given_up ? 0 : 1 + child.kept;
    }
    Frame& frame = frames_[at_];
    const unsigned child = lowest(frame.left);
    frame.left = without_lowest(frame.left);
    enter(pool_->child(frame.node, child));
    return true;
}

} // namespace osem
