// Booleans of runs, row by row: the floor for Booleans of trees.
#ifndef OSEM_BENCH_RUN_BOOLEAN_HPP
#define OSEM_BENCH_RUN_BOOLEAN_HPP

#include "bench/scanline.hpp"
#include "osem/boolean.hpp"

namespace osem::bench {

/// `a op b`, which have the same side.
void combine(Operator op, const RunGrid& a, const RunGrid& b, RunGrid& result);

} // namespace osem::bench

#endif
