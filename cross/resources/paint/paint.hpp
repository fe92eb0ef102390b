// Painting the stack of every public function: what the topics share. A topic is one file with one function
// below, called from main.cpp.
#ifndef OSEM_CROSS_PAINT_HPP
#define OSEM_CROSS_PAINT_HPP

#include <cstdint>

#include "osem/osem.hpp"
#include "paint/stack_used.hpp"
#include "platform.hpp"

namespace osem::cross {

extern NodePool& pool;       ///< holds the trees below
extern NodePool& other_pool; ///< for results

/// Notes a call that does not give what it should, so that no path is measured that was not taken.
void expect(bool condition);

/// Prints the line `stack NAME BYTES` of one call.
void print_stack(const char* name, std::uint32_t bytes);

/// Measures `call`, a lambda that calls the public function of that name and little else. A function may be
/// measured several times; the most counts.
template <class Call>
[[gnu::always_inline]] inline void measured(const char* name, Call call) {
    print_stack(name, stack_used_by(call));
}

/// Two trees of overlapping spheres, in `pool`.
struct PaintTrees {
    Octree a;
    Octree b;
};

PaintTrees paint_solids(); ///< also converts the trees that the others use
void paint_bintree();
void paint_booleans(const PaintTrees& trees);
void paint_queries(const PaintTrees& trees);
void paint_measures(const PaintTrees& trees);
void paint_trees(const PaintTrees& trees);
void paint_transforms(const PaintTrees& trees);
void paint_slices(const PaintTrees& trees);
void paint_boundary(const PaintTrees& trees);
void paint_streams(const PaintTrees& trees);
void paint_csg(const PaintTrees& trees);
void paint_fit(const PaintTrees& trees);
void paint_memory(const PaintTrees& trees); ///< comes last: it moves the trees

} // namespace osem::cross

#endif
