// Osem's speed beside that of others: the same solids on the same lattice in one process, on one thread.
#include "bench/solids.hpp"
#include "bench/suites.hpp"

namespace {

void add_all() {
    for (const char* solid : {"armadillo", "rotor", "elephant", "bracket"}) {
        if (!osem::bench::is_available(solid)) continue;
        for (int depth = 6; depth <= 11; ++depth) osem::bench::add_conversions(solid, depth);
    }
    for (const char* solid :
         {"sphere-1280", "sphere-5120", "sphere-20480", "sphere-81920", "sphere-327680", "sphere-1310720",
          "dot-1280", "dot-5120", "dot-20480", "dot-81920", "dot-327680", "dot-1310720"}) {
        osem::bench::add_conversions(solid, 10);
    }
}

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    add_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
