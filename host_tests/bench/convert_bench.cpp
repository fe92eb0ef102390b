// Conversion: Osem's two kinds of leaves, by grids and plain, and the scanlines.
#include "bench/suites.hpp"

#include "bench/agreement.hpp"
#include "bench/osem_conversion.hpp"
#include "bench/scanline.hpp"
#include "bench/simple_scanline.hpp"

namespace osem::bench {

namespace {

void set_counters(benchmark::State& state, const std::string& solid, int depth, std::uint64_t result_bytes,
                  std::uint64_t memory_bytes) {
    const Agreement& agreement = agreement_on(solid, depth);
    state.counters["triangles"] = static_cast<double>(solid_of(solid).triangles.size());
    state.counters["cells"] = static_cast<double>(agreement.cells);
    state.counters["boundary_cells"] = static_cast<double>(agreement.boundary_cells);
    state.counters["result_bytes"] = static_cast<double>(result_bytes);
    state.counters["memory_bytes"] = static_cast<double>(memory_bytes);
}

template <class Job>
void run(benchmark::State& state, const std::string& solid, int depth, OsemConversion<Job>& conversion) {
    for (auto _ : state) conversion.run();
    set_counters(state, solid, depth, conversion.result_bytes(), conversion.memory_bytes());
    state.counters["nodes"] = static_cast<double>(measure(conversion.tree()).nodes);
}

void run_grids(benchmark::State& state, const std::string& solid, int depth, LeafRule leaves) {
    static_cast<void>(agreement_on(solid, depth));
    OsemConversion<GridConversion>& conversion = conversion_of(solid, depth, leaves);
    run(state, solid, depth, conversion);
    state.counters["grids"] = static_cast<double>(conversion.job().grids_visited());
}

void run_plain(benchmark::State& state, const std::string& solid, int depth, LeafRule leaves) {
    OsemConversion<Conversion> conversion(solid_of(solid), depth, leaves);
    require(same_leaves(conversion.tree(), conversion_of(solid, depth, leaves).tree()),
            "another tree by grids");
    run(state, solid, depth, conversion);
    state.counters["octants"] = static_cast<double>(conversion.job().octants_visited());
}

template <class AnyScanline>
void run_scanline(benchmark::State& state, const std::string& name, int depth, bool as_bits) {
    static_cast<void>(agreement_on(name, depth));
    const BenchSolid& solid = solid_of(name);
    AnyScanline scanline;
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
    add("scan-runs", [=](benchmark::State& state) { run_scanline<Scanline>(state, solid, depth, false); });
    add("scan-bits", [=](benchmark::State& state) { run_scanline<Scanline>(state, solid, depth, true); });
    add("scan-simple",
        [=](benchmark::State& state) { run_scanline<SimpleScanline>(state, solid, depth, false); });
    add("osem-centre", [=](benchmark::State& state) { run_grids(state, solid, depth, LeafRule::centre); });
    add("osem-three",
        [=](benchmark::State& state) { run_grids(state, solid, depth, LeafRule::conservative); });
    add("plain-centre", [=](benchmark::State& state) { run_plain(state, solid, depth, LeafRule::centre); });
    add("plain-three",
        [=](benchmark::State& state) { run_plain(state, solid, depth, LeafRule::conservative); });
}

} // namespace osem::bench
