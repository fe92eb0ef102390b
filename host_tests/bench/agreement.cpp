#include "bench/agreement.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "bench/osem_conversion.hpp"
#include "bench/scanline.hpp"

namespace osem::bench {

namespace {

Measures measures_of(const BenchSolid& solid, int depth, LeafRule leaves) {
    OsemConversion conversion(solid, depth, leaves);
    return measure(conversion.run());
}

void require_equal(std::uint64_t cells, std::uint64_t other, const std::string& what) {
    require(cells == other, what + ": " + std::to_string(cells) + " cells in the centre tree, " +
                                std::to_string(other) + " otherwise");
}

Agreement agree(const std::string& name, int depth) {
    const BenchSolid& solid = solid_of(name);
    const std::uint64_t cell = volume_at(depth);
    const Measures centre = measures_of(solid, depth, LeafRule::centre);
    const Measures three = measures_of(solid, depth, LeafRule::conservative);
    Scanline scanline;
    RunGrid runs;
    scanline.convert(solid.solid.vertices, solid.triangles, depth, runs);
    BitGrid bits;
    fill_bits(runs, bits);

    const std::string what = name + " at depth " + std::to_string(depth);
    const Agreement result{centre.inner_volume / cell, three.inner_volume / cell,
                           (three.outer_volume - three.inner_volume) / cell};
    require_equal(result.cells, centre.outer_volume / cell, what + ", outer volume");
    require_equal(result.cells, runs.cells(), what + ", runs");
    require_equal(result.cells, bits.cells(), what + ", bits");
    require(result.inner_cells <= result.cells && result.cells <= result.inner_cells + result.boundary_cells,
            what + ": the centre tree is not between the inner and the outer solid");
    return result;
}

} // namespace

void require(bool holds, const std::string& message) {
    if (holds) return;
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(1);
}

const Agreement& agreement_on(const std::string& solid, int depth) {
    static std::map<std::pair<std::string, int>, Agreement> known;
    const auto key = std::make_pair(solid, depth);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known.emplace(key, agree(solid, depth)).first->second;
}

} // namespace osem::bench
