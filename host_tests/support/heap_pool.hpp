// A node pool with memory of its own, and ways to see whether anything in it has changed.
#ifndef OSEM_SUPPORT_HEAP_POOL_HPP
#define OSEM_SUPPORT_HEAP_POOL_HPP

#include <cstdint>
#include <cstring>
#include <set>
#include <vector>

#include "osem/node_pool.hpp"
#include "osem/octree.hpp"

namespace osem::tests {

/// The memory has exactly the pool's size, so that the address sanitizer sees a write behind it.
class HeapPool {
  public:
    explicit HeapPool(std::uint32_t capacity)
        : memory_(capacity, Node::uniform(Colour::white)), pool_(memory_.data(), capacity) {}
    HeapPool(const HeapPool&) = delete;
    HeapPool& operator=(const HeapPool&) = delete;

    NodePool& operator*() { return pool_; }
    NodePool* operator->() { return &pool_; }
    const Node* memory() const { return memory_.data(); }
    std::vector<Node> used_nodes() const { return {memory_.data(), memory_.data() + pool_.used()}; }

    /// Writes nodes of no meaning until `used` are in use.
    void fill_to(std::uint32_t used) {
        const Node filler = Node::of(0x12, 0x12, 0);
        NodeIndex first = 0;
        while (pool_.used() < used) pool_.append(&filler, 1, first);
    }

    /// A pool of exactly `capacity` nodes which starts with the nodes of another one.
    HeapPool(const HeapPool& other, std::uint32_t capacity) : HeapPool(capacity) {
        const std::vector<Node> nodes = other.used_nodes();
        NodeIndex first = 0;
        pool_.append(nodes.data(), static_cast<std::uint32_t>(nodes.size()), first);
    }

  private:
    std::vector<Node> memory_;
    NodePool pool_;
};

/// The bytes of an object, padding included.
template <class T>
std::vector<unsigned char> bytes_of(const T& object) {
    std::vector<unsigned char> bytes(sizeof object);
    std::memcpy(bytes.data(), &object, sizeof object);
    return bytes;
}

/// What a pool held at some time: the bytes of its nodes and its counters.
class PoolImage {
  public:
    explicit PoolImage(HeapPool& pool)
        : nodes_(pool.used_nodes()), used_(pool->used()), refused_(pool->refused()) {}

    /// Whether the same nodes are in use, byte for byte.
    bool same_nodes(HeapPool& pool) const {
        return pool->used() == used_ &&
               (used_ == 0 || std::memcmp(nodes_.data(), pool.memory(), nodes_.size() * sizeof(Node)) == 0);
    }
    std::uint32_t refused() const { return refused_; }

  private:
    std::vector<Node> nodes_;
    std::uint32_t used_;
    std::uint32_t refused_;
};

/// The distinct nodes of the pool that a tree reaches, found without the kernel's walks.
inline void collect_reachable(const NodePool& pool, const Node& node, std::set<std::uint32_t>& reached) {
    std::uint32_t index = node.first();
    for (unsigned k = 0; k < 8; ++k) {
        const bool is_grey = ((node.must >> k) & 1U) != 0 && ((node.may >> k) & 1U) == 0;
        if (!is_grey) continue;
        reached.insert(index);
        collect_reachable(pool, pool.at(static_cast<NodeIndex>(index)), reached);
        ++index;
    }
}

inline std::set<std::uint32_t> reachable(const Octree& tree) {
    std::set<std::uint32_t> reached;
    collect_reachable(*tree.pool, tree.top, reached);
    return reached;
}

} // namespace osem::tests

#endif
