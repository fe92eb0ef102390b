#include "bench/agreement.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "bench/osem_conversion.hpp"
#include "bench/scanline.hpp"
#include "bench/simple_scanline.hpp"

namespace osem::bench {

namespace {

// Ends the program unless the centre tree, both scanlines' runs and the bits are one set of cells; returns
// their number.
std::uint64_t agreed_cells(const std::string& name, int depth, const std::string& what) {
    const BenchSolid& solid = solid_of(name);
    const Octree& tree = conversion_of(name, depth, LeafRule::centre).tree();
    const Measures measures = measure(tree);
    require(measures.boundary_leaves == 0, what + ": the centre tree has boundary leaves");
    Scanline scanline;
    RunGrid runs;
    scanline.convert(solid.solid.vertices, solid.triangles, depth, runs);
    SimpleScanline simple;
    RunGrid simple_runs;
    simple.convert(solid.solid.vertices, solid.triangles, depth, simple_runs);
    require(simple_runs.starts == runs.starts && simple_runs.boundaries == runs.boundaries,
            what + ": other runs by the simple scanline");
    BitGrid bits;
    fill_bits(runs, bits);
    const std::uint64_t cells = measures.inner_volume / volume_at(depth);
    require(cells == runs.cells() && cells == bits.cells(),
            what + ": " + std::to_string(cells) + " cells in the centre tree, " +
                std::to_string(runs.cells()) + " in runs, " + std::to_string(bits.cells()) + " in bits");
    require(bits.words == bits_of(tree, depth).words, what + ": as many cells, but not the same ones");
    return cells;
}

Agreement agree(const std::string& name, int depth) {
    const std::string what = name + " at depth " + std::to_string(depth);
    const std::uint64_t cells = agreed_cells(name, depth, what);
    const Measures measures = measure(conversion_of(name, depth, LeafRule::conservative).tree());
    const std::uint64_t inner = measures.inner_volume / volume_at(depth);
    const std::uint64_t outer = measures.outer_volume / volume_at(depth);
    require(inner <= cells && cells <= outer,
            what + ": the centre tree is not between inner and outer solid");
    return Agreement{cells, inner, outer - inner};
}

} // namespace

void require(bool holds, const std::string& message) {
    if (holds) return;
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(1);
}

BitGrid bits_of(const Octree& tree, int depth) {
    const std::uint32_t side = 1U << depth;
    const int shift = lattice_bits - depth;
    BitGrid bits;
    bits.side = side;
    bits.words.assign(std::size_t{side} * side * side / 64, 0);
    LeafWalk walk(tree);
    for (Leaf leaf{}; walk.next(leaf);) {
        if (leaf.colour != Colour::black) continue;
        const auto low = [&](int axis) {
            return static_cast<std::size_t>(leaf.octant.corner.at[axis] >> shift);
        };
        const auto length = static_cast<std::uint32_t>(leaf.octant.side() >> shift);
        for (std::size_t z = low(2); z < low(2) + length; ++z) {
            for (std::size_t y = low(1); y < low(1) + length; ++y) {
                const auto x = static_cast<std::uint32_t>(low(0));
                set_bits(&bits.words[(z * side + y) * side / 64], x, x + length);
            }
        }
    }
    return bits;
}

const Agreement& agreement_on(const std::string& solid, int depth) {
    static std::map<std::pair<std::string, int>, Agreement> known;
    const auto key = std::make_pair(solid, depth);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known.emplace(key, agree(solid, depth)).first->second;
}

} // namespace osem::bench
