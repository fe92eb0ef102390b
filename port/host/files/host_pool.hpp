// A node pool with its memory on the heap.
#ifndef OSEM_HOST_POOL_HPP
#define OSEM_HOST_POOL_HPP

#include <cstdint>
#include <memory>
#include <new>

#include "osem/octree.hpp"

namespace osem::host {

/// The memory is left uninitialised, so that pages the tree never reaches are never touched.
class HostPool {
  public:
    explicit HostPool(std::uint64_t capacity)
        : memory_(new Node[checked(capacity)]), pool_(memory_.get(), static_cast<std::uint32_t>(capacity)) {}

    /// A pool with the nodes of `other` at the same indices and room for `capacity` nodes in all.
    HostPool(const HostPool& other, std::uint64_t capacity) : HostPool(capacity) {
        NodeIndex first = 0;
        static_cast<void>(pool_.append(other.memory_.get(), other.pool_.used(), first));
    }

    NodePool& pool() { return pool_; }

    /// A tree of another pool, as it stands in this copy of that pool.
    Octree adopted(const Octree& tree) const { return Octree{&pool_, tree.top, tree.depth}; }

  private:
    static std::size_t checked(std::uint64_t capacity) {
        if (capacity > NodePool::max_capacity) throw std::bad_alloc();
        return static_cast<std::size_t>(capacity);
    }

    std::unique_ptr<Node[]> memory_;
    NodePool pool_;
};

} // namespace osem::host

#endif
