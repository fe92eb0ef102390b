// Conversion: Osem's two kinds of leaves and the two scanlines.
#include "bench/suites.hpp"

#include "bench/agreement.hpp"
#include "bench/osem_conversion.hpp"
#include "bench/scanline.hpp"

namespace osem::bench {

namespace {

void set_counters(benchmark::State& state, const std::string& solid, int depth, std::uint64_t result_bytes,
                  std::uint64_t memory_bytes) {
    const Agreement& agreement = agreement_on(solid, depth);
    state.counters["faces"] = static_cast<double>(solid_of(solid).triangles.size());
    state.counters["cells"] = static_cast<double>(agreement.cells);
    state.counters["boundary_cells"] = static_cast<double>(agreement.boundary_cells);
    state.counters["result_bytes"] = static_cast<double>(result_bytes);
    state.counters["memory_bytes"] = static_cast<double>(memory_bytes);
}

void run_osem(benchmark::State& state, const std::string& solid, int depth, LeafRule leaves) {
    static_cast<void>(agreement_on(solid, depth));
    OsemConversion& conversion = conversion_of(solid, depth, leaves);
    for (auto _ : state) conversion.run();
    set_counters(state, solid, depth, conversion.result_bytes(), conversion.memory_bytes());
    state.counters["nodes"] = static_cast<double>(measure(conversion.tree()).nodes);
    state.counters["octants"] = static_cast<double>(conversion.octants_visited());
}

void run_scanline(benchmark::State& state, const std::string& name, int depth, bool as_bits) {
    static_cast<void>(agreement_on(name, depth));
    const BenchSolid& solid = solid_of(name);
    Scanline scanline;
    RunGrid runs;
    BitGrid bits;
    const auto run = [&] {
        scanline.convert(solid.solid.vertices, solid.triangles, depth, runs);
        if (as_bits) fill_bits(runs, bits);
        benchmark::ClobberMemory();
    };
    run(); // allocates, and touches the pages
    for (auto _ : state) run();
    const std::uint64_t result = as_bits ? bits.bytes() : runs.bytes();
    const std::uint64_t intermediate = as_bits ? runs.bytes() : 0;
    set_counters(state, name, depth, result, result + intermediate + scanline.bytes());
}

} // namespace

void add_conversions(const std::string& solid, int depth) {
    const std::string name = conversion_name(solid, depth);
    const auto add = [&name](const char* method, auto run) {
        benchmark::RegisterBenchmark((name + method).c_str(), run)->Unit(benchmark::kMillisecond);
    };
    add("scan-runs", [=](benchmark::State& state) { run_scanline(state, solid, depth, false); });
    add("scan-bits", [=](benchmark::State& state) { run_scanline(state, solid, depth, true); });
    add("osem-centre", [=](benchmark::State& state) { run_osem(state, solid, depth, LeafRule::centre); });
    add("osem-three",
        [=](benchmark::State& state) { run_osem(state, solid, depth, LeafRule::conservative); });
}

} // namespace osem::bench
