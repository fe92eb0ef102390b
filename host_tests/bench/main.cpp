// Osem's speed beside that of others: the same solids on the same lattice in one process, on one thread.
#include "bench/suites.hpp"

#include <iostream>

namespace {

void add_conversion(const std::string& solid, int depth) {
    osem::bench::add_conversions(solid, depth);
#ifdef OSEM_BENCH_VDB
    if (depth <= 10) osem::bench::add_vdb_conversion(solid, depth); // 2048 takes a minute
#endif
}

void add_boolean(const osem::bench::Pair& pair, osem::Operator op) {
    osem::bench::add_boolean(pair, op);
#ifdef OSEM_BENCH_VDB
    osem::bench::add_vdb_boolean(pair, op);
#endif
#ifdef OSEM_BENCH_CGAL
    osem::bench::add_cgal_boolean(pair, op);
#endif
}

void add_conversions() {
    add_conversion("ties", 8);
    for (const char* solid : {"armadillo", "rotor", "elephant", "bracket"}) {
        for (int depth = 6; depth <= 10; ++depth) add_conversion(solid, depth);
    }
    for (const char* solid : {"armadillo", "rotor"}) add_conversion(solid, 11);
    for (const char* solid :
         {"sphere-1280", "sphere-5120", "sphere-20480", "sphere-81920", "sphere-327680", "sphere-1310720",
          "dot-1280", "dot-5120", "dot-20480", "dot-81920", "dot-327680", "dot-1310720"}) {
        add_conversion(solid, 10);
    }
}

void add_threads() {
    for (const char* solid : {"armadillo", "rotor", "sphere-1310720"}) osem::bench::add_threads(solid, 10);
}

void add_booleans() {
    using osem::Operator;
    for (int depth = 8; depth <= 10; ++depth) {
        for (const char* other : {"elephant", "sphere-81920"}) {
            for (const Operator op : {Operator::unite, Operator::intersect, Operator::subtract}) {
                add_boolean({"armadillo", other, depth}, op);
            }
        }
    }
    // Less of the solids is where their surfaces meet.
    osem::bench::add_boolean({"armadillo", "elephant", 11}, Operator::unite);
}

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    add_conversions();
    add_threads();
    add_booleans();
    const std::size_t matched = benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    if (matched != 0) return 0;
    std::cerr
        << "osem_bench: the filter matches no measurement; --benchmark_list_tests lists them, and a + in a "
           "name is \\+ in a filter\n";
    return 1;
}
