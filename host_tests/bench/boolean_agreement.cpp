#include "bench/boolean_agreement.hpp"

#include <map>
#include <utility>

#include "bench/agreement.hpp"

namespace osem::bench {

RunPair runs_of(const Pair& pair) {
    RunPair runs;
    const BenchSolid& a = solid_of(pair.a);
    const BenchSolid& b = solid_of(pair.b);
    Scanline scanline;
    scanline.convert(a.solid.vertices, a.triangles, pair.depth, runs.a);
    scanline.convert(b.solid.vertices, b.triangles, pair.depth, runs.b);
    return runs;
}

OsemPair& trees_of(const Pair& pair, LeafRule leaves) {
    static std::map<LeafRule, std::pair<Pair, std::unique_ptr<OsemPair>>> known;
    auto& [of, made] = known[leaves];
    if (made == nullptr || !(of == pair)) {
        of = pair;
        made = std::make_unique<OsemPair>(solid_of(pair.a), solid_of(pair.b), pair.depth, leaves);
    }
    return *made;
}

std::uint64_t agreed_cells(const Pair& pair, Operator op) {
    OsemPair& trees = trees_of(pair, LeafRule::centre);
    trees.prepare(op);
    const Octree result = trees.combine_in_pool(op);
    const std::string what = pair.a + " and " + pair.b + " at depth " + std::to_string(pair.depth);
    require(trees.combine_streams(op) == stream_of(result), what + ": streams and pool differ");
    const RunPair runs = runs_of(pair);
    RunGrid combined;
    combine(op, runs.a, runs.b, combined);
    const std::uint64_t cells = measure(result).inner_volume / volume_at(pair.depth);
    require(cells == combined.cells(), what + ": tree and runs differ");
    return cells;
}

} // namespace osem::bench
