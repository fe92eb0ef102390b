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

namespace {

Octree agreed_tree(const Pair& pair, Operator op, LeafRule leaves, const std::string& what) {
    OsemPair& trees = trees_of(pair, leaves);
    trees.prepare(op);
    const Octree result = trees.combine_in_pool(op);
    for (const Known known : {Known::nothing, Known::checked, Known::indexed}) {
        require(trees.combine_streams(op, known) == stream_of(result), what + ": streams and pool differ");
    }
    return result;
}

} // namespace

std::uint64_t agreed_cells(const Pair& pair, Operator op) {
    const std::string what = pair.a + " and " + pair.b + " at depth " + std::to_string(pair.depth);
    static_cast<void>(agreed_tree(pair, op, LeafRule::conservative, what));
    const Octree result = agreed_tree(pair, op, LeafRule::centre, what);
    const RunPair runs = runs_of(pair);
    RunGrid combined;
    combine(op, runs.a, runs.b, combined);
    BitGrid bits;
    fill_bits(combined, bits);
    require(bits.words == bits_of(result, pair.depth).words, what + ": tree and runs differ");
    return combined.cells();
}

} // namespace osem::bench
