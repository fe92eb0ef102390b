#include "osem/node_pool.hpp"

namespace osem {

Status NodePool::append(const Node* nodes, std::uint32_t count, NodeIndex& first) {
    if (count > capacity_ - used_) {
        ++refused_;
        return Status::pool_exhausted;
    }
    first = static_cast<NodeIndex>(used_);
    for (std::uint32_t i = 0; i < count; ++i) memory_[used_ + i] = nodes[i];
    used_ += count;
    if (used_ > peak_) peak_ = used_;
    return Status::ok;
}

void NodePool::roll_back(std::uint32_t mark) {
    OSEM_ASSERT(mark <= used_);
    if (read_only()) return; // stays full, which is why append never gets to write
    used_ = mark;
}

} // namespace osem
