// Conversion as the tool does it, on several threads: with an estimate of its size, and joining the parts.
#include <chrono>
#include <iostream>

#include "bench/agreement.hpp"
#include "bench/osem_conversion.hpp"
#include "bench/suites.hpp"
#include "commands/octants_apart.hpp"

namespace osem::bench {

namespace {

// Time by the clock, without the comparison: processor time is that of one thread.
void run_threads(benchmark::State& state, const std::string& name, int depth, unsigned threads) {
    const BenchSolid& solid = solid_of(name);
    const ConvertOptions options = {depth, LeafRule::conservative, WindingRule::nonzero};
    const host::Console console = {std::cout, std::cerr, false};
    host::Progress progress(console, "");
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        const host::Converted converted =
            host::convert_octants_apart(solid.checked(), options, threads, progress);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        state.SetIterationTime(seconds.count());
        require(same_leaves(converted.tree, conversion_of(name, depth, options.leaves).tree()),
                "another tree on several threads");
    }
}

} // namespace

void add_threads(const std::string& solid, int depth) {
    const std::string name = "threads/" + solid + "/" + std::to_string(1 << depth) + "/threads-";
    for (const unsigned threads : {1U, 2U, 4U, 8U}) {
        benchmark::RegisterBenchmark(
            (name + std::to_string(threads)).c_str(),
            [=](benchmark::State& state) { run_threads(state, solid, depth, threads); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime();
    }
}

} // namespace osem::bench
