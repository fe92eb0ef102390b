// Registers what is measured. Names are theme/solid/cells-along-an-axis/method.
#ifndef OSEM_BENCH_SUITES_HPP
#define OSEM_BENCH_SUITES_HPP

#include <string>

#include <benchmark/benchmark.h>

namespace osem::bench {

void add_conversions(const std::string& solid, int depth);

} // namespace osem::bench

#endif
