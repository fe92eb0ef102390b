#include "bench/osem_conversion.hpp"

#include <map>

#include "bench/agreement.hpp"

namespace osem::bench {

namespace {

std::uint64_t scratch_size(const Conversion&, const Solid& solid, int) { return convert_scratch(solid); }
std::uint64_t scratch_size(const GridConversion&, const Solid& solid, int depth) {
    return grid_scratch(solid, depth);
}

} // namespace

template <class Job>
OsemConversion<Job>::OsemConversion(const BenchSolid& solid, int depth, LeafRule leaves)
    : solid_(solid.checked()), options_{depth, leaves, WindingRule::nonzero},
      scratch_(bench::scratch_size(*job_, solid_.view(), depth)) {
    const auto scratch_size = static_cast<std::uint32_t>(scratch_.size());
    const TreeOutcome counted = convert(*job_, solid_, options_, scratch_.data(), scratch_size, nullptr);
    require(counted.status == Status::ok, describe(counted.status));
    nodes_ = counted.nodes_needed;
    pool_ = std::make_unique<host::HostPool>(nodes_);
    run();
}

template <class Job>
void OsemConversion<Job>::run() {
    pool_->pool().roll_back(0);
    const auto scratch_size = static_cast<std::uint32_t>(scratch_.size());
    const TreeOutcome outcome =
        convert(*job_, solid_, options_, scratch_.data(), scratch_size, &pool_->pool());
    require(outcome.status == Status::ok, describe(outcome.status));
    tree_ = outcome.tree;
}

template class OsemConversion<Conversion>;
template class OsemConversion<GridConversion>;

OsemConversion<GridConversion>& conversion_of(const std::string& solid, int depth, LeafRule leaves) {
    struct Made {
        std::string solid;
        int depth = 0;
        std::unique_ptr<OsemConversion<GridConversion>> conversion;
    };
    static std::map<LeafRule, Made> known;
    Made& made = known[leaves];
    if (made.solid != solid || made.depth != depth) {
        made = Made{solid, depth,
                    std::make_unique<OsemConversion<GridConversion>>(solid_of(solid), depth, leaves)};
    }
    return *made.conversion;
}

} // namespace osem::bench
