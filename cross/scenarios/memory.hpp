// The memory that all scenarios work in: so little that a part with 16 KB of RAM runs every one of them.
#ifndef OSEM_SCENARIOS_MEMORY_HPP
#define OSEM_SCENARIOS_MEMORY_HPP

#include <cstddef>
#include <new>

#include "osem/osem.hpp"

namespace osem::cross {

constexpr std::uint32_t pool_capacity = 1150;
constexpr std::uint32_t most_corners = 64;
constexpr std::uint32_t most_vertices = 20; // those of the plate, or of five tetrahedra

/// A pool that every scenario finds empty.
extern NodePool& pool;
extern Conversion conversion;

/// Where every other job lives, one at a time. Checksums of streams take more where registers are wide.
constexpr std::size_t workspace_size = has_wide_registers ? 8448 : 3040;
alignas(8) extern unsigned char workspace[workspace_size];

/// A new job, or scratch of any plain type, in the workspace; what stood there before is gone.
template <class Job, class... Arguments>
Job& fresh(const Arguments&... arguments) {
    static_assert(sizeof(Job) <= workspace_size && alignof(Job) <= 8, "has to fit the workspace");
    return *new (workspace) Job(arguments...);
}

/// Checks and converts a solid of at most most_corners corners and 32 faces into the pool, or, without one,
/// counts. What check refuses comes back as its status. Not inlined: the stack that check takes is free again
/// before the scenario goes on.
[[gnu::noinline]] TreeOutcome converted(const Solid& solid, const ConvertOptions& options,
                                        NodePool* into = &pool);

/// Scratch of check, and of the fault scenarios for their own use.
extern Edge edges[most_corners];

} // namespace osem::cross

#endif
