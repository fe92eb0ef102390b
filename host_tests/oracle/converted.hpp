// Kernel calls with memory from the heap, for the oracle tests.
#ifndef OSEM_ORACLE_CONVERTED_HPP
#define OSEM_ORACLE_CONVERTED_HPP

#include <optional>
#include <vector>

#include "osem/boolean.hpp"
#include "osem/convert.hpp"
#include "osem/node_pool.hpp"
#include "osem/solid.hpp"

namespace oracle {

/// A pool of its own size on the heap.
class HeapPool {
  public:
    explicit HeapPool(std::uint32_t capacity)
        : memory_(capacity, osem::Node::uniform(osem::Colour::white)), pool_(memory_.data(), capacity) {}
    osem::NodePool& operator*() { return pool_; }

  private:
    std::vector<osem::Node> memory_;
    osem::NodePool pool_;
};

inline osem::CheckOutcome checked(const osem::Solid& solid) {
    std::vector<osem::Edge> scratch(osem::check_scratch(solid));
    return osem::check(solid, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
}

inline osem::TreeOutcome converted(const osem::CheckedSolid& solid, const osem::ConvertOptions& options,
                                   osem::NodePool& pool) {
    std::vector<std::uint32_t> scratch(osem::convert_scratch(solid.view()));
    osem::Conversion job;
    return osem::convert(job, solid, options, scratch.data(), static_cast<std::uint32_t>(scratch.size()),
                         &pool);
}

} // namespace oracle

#endif
