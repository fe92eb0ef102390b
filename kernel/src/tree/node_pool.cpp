#include "osem/node_pool.hpp"

namespace osem {

Node* NodePool::extend(std::uint32_t count, NodeIndex& first) {
    if (count > capacity_ - used_) {
        ++refused_;
        return nullptr;
    }
    first = static_cast<NodeIndex>(used_);
    used_ += count;
    if (used_ > peak_) peak_ = used_;
    return memory_ + first;
}

Status NodePool::append(const Node* nodes, std::uint32_t count, NodeIndex& first) {
    if (count == 0) { // there may be no memory
        first = static_cast<NodeIndex>(used_);
        return Status::ok;
    }
    Node* const to = extend(count, first);
    if (to == nullptr) return Status::pool_exhausted;
    for (std::uint32_t i = 0; i < count; ++i) to[i] = nodes[i];
    return Status::ok;
}

void NodePool::roll_back(std::uint32_t mark) {
    OSEM_ASSERT(mark <= used_);
    if (read_only()) return; // stays full, which is why extend gives no room
    used_ = mark;
}

} // namespace osem
