// Booleans: Osem's in a pool and from stream to stream, and those of runs.
#include "bench/suites.hpp"

#include "bench/boolean_agreement.hpp"
#include "bench/run_boolean.hpp"

namespace osem::bench {

namespace {

void run_pool(benchmark::State& state, const Pair& pair, Operator op, LeafRule leaves) {
    static_cast<void>(agreed_cells(pair, op));
    OsemPair& trees = trees_of(pair, leaves);
    trees.prepare(op);
    for (auto _ : state) benchmark::DoNotOptimize(trees.combine_in_pool(op));
    const std::uint64_t result = trees.nodes_added() * sizeof(Node);
    state.counters["nodes"] = static_cast<double>(trees.nodes());
    state.counters["result_bytes"] = static_cast<double>(result);
    state.counters["memory_bytes"] =
        static_cast<double>(result + trees.nodes() * sizeof(Node) + sizeof(Combination));
}

void run_streams(benchmark::State& state, const Pair& pair, Operator op, LeafRule leaves,
                 Known known = Known::nothing) {
    static_cast<void>(agreed_cells(pair, op));
    OsemPair& trees = trees_of(pair, leaves);
    const auto combined = [&]() -> const Bytes& { return trees.combine_streams(op, known); };
    std::uint64_t result = combined().size(); // touches the pages
    for (auto _ : state) benchmark::DoNotOptimize(result = combined().size());
    state.counters["nodes"] = static_cast<double>(trees.nodes());
    state.counters["result_bytes"] = static_cast<double>(result);
    state.counters["memory_bytes"] =
        static_cast<double>(result + trees.stream_bytes(known) + sizeof(StreamCombination));
}

void run_runs(benchmark::State& state, const Pair& pair, Operator op) {
    static_cast<void>(agreed_cells(pair, op));
    const RunPair runs = runs_of(pair);
    RunGrid result;
    combine(op, runs.a, runs.b, result);
    for (auto _ : state) {
        combine(op, runs.a, runs.b, result);
        benchmark::ClobberMemory();
    }
    state.counters["cells"] = static_cast<double>(result.cells());
    state.counters["result_bytes"] = static_cast<double>(result.bytes());
    state.counters["memory_bytes"] = static_cast<double>(result.bytes() + runs.a.bytes() + runs.b.bytes());
}

} // namespace

void add_boolean(const Pair& pair, Operator op) {
    const std::string name = boolean_name(pair, op);
    const auto add = [&name](const char* method, auto run) {
        benchmark::RegisterBenchmark((name + method).c_str(), run)->Unit(benchmark::kMillisecond);
    };
    add("runs", [=](benchmark::State& state) { run_runs(state, pair, op); });
    add("osem-pool", [=](benchmark::State& state) { run_pool(state, pair, op, LeafRule::centre); });
    add("osem-stream", [=](benchmark::State& state) { run_streams(state, pair, op, LeafRule::centre); });
    add("osem-stream-checked",
        [=](benchmark::State& state) { run_streams(state, pair, op, LeafRule::centre, Known::checked); });
    add("osem-stream-indexed",
        [=](benchmark::State& state) { run_streams(state, pair, op, LeafRule::centre, Known::indexed); });
    add("osem-pool-three",
        [=](benchmark::State& state) { run_pool(state, pair, op, LeafRule::conservative); });
    add("osem-stream-three",
        [=](benchmark::State& state) { run_streams(state, pair, op, LeafRule::conservative); });
}

} // namespace osem::bench
