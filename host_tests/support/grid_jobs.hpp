// Conversion by grids in the tests: with scratch of a size, and of boxes.
#ifndef OSEM_TESTS_GRID_JOBS_HPP
#define OSEM_TESTS_GRID_JOBS_HPP

#include <cstdint>
#include <vector>

#include "osem/grid_convert.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

/// Scratch of exactly so many words, so that the address sanitizer sees one too many.
struct GridScratch {
    std::vector<std::uint32_t> words;

    explicit GridScratch(std::uint64_t size) : words(static_cast<std::size_t>(size)) {}
    std::uint32_t size() const { return static_cast<std::uint32_t>(words.size()); }
    Status begin(GridConversion& job, const SmallSolid& solid, const ConvertOptions& options, NodePool* pool,
                 int last_levels = most_grid_levels) {
        return job.begin(solid.checked(), options, words.data(), size(), pool, {last_levels});
    }
    TreeOutcome run(GridConversion& job, const SmallSolid& solid, const ConvertOptions& options,
                    NodePool* pool, int last_levels = most_grid_levels) {
        return convert(job, solid.checked(), options, words.data(), size(), pool, {last_levels});
    }
};

/// A cube between two sixteenths of the root's side.
inline Box box(std::int32_t low, std::int32_t high, int winding = 1) {
    constexpr std::int32_t unit = root_side / 16;
    return {{{low * unit, low * unit, low * unit}}, {{high * unit, high * unit, high * unit}}, winding};
}

} // namespace osem::tests

#endif
