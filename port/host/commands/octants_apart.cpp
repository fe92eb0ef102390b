#include "commands/octants_apart.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "commands/stopwatch.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

struct Part {
    std::unique_ptr<HostPool> pool;
    Octree tree = {};
    std::uint64_t grids = 0;
    std::uint32_t nodes = 0;
    std::uint32_t scratch_used = 0;
};

// The children of the root, and the threads that take one after the other. The thread that makes it is one of
// them, and shows how far all are.
class Crew {
  public:
    Crew(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress)
        : solid_(solid), options_(options), progress_(progress) {}

    std::array<Part, 8>& work(unsigned threads) {
        std::vector<std::thread> others;
        others.reserve(threads);
        try {
            for (unsigned i = 1; i < threads; ++i) others.emplace_back([this] { work_on(nullptr); });
        } catch (const std::system_error&) { // the system starts no more: fewer do it as well
        }
        work_on(&progress_);
        for (std::thread& other : others) other.join();
        if (failure_) std::rethrow_exception(failure_);
        return parts_;
    }

  private:
    void work_on(Progress* progress) {
        try {
            const auto job = std::make_unique<GridConversion>();
            std::vector<std::uint32_t> scratch(grid_words(solid_.view(), options_.depth - 1));
            for (unsigned child = next_++; child < parts_.size(); child = next_++) {
                convert(*job, scratch, child, progress);
            }
        } catch (...) {
            const std::lock_guard<std::mutex> lock(failing_);
            failure_ = std::current_exception();
            next_ = static_cast<unsigned>(parts_.size()); // the others end as well
        }
    }

    // Twice: the first pass only counts the nodes.
    void convert(GridConversion& job, std::vector<std::uint32_t>& scratch, unsigned child,
                 Progress* progress) {
        Part& part = parts_[child];
        part.nodes = run(job, scratch, child, nullptr, progress).nodes_needed;
        part.pool = std::make_unique<HostPool>(part.nodes);
        part.tree = run(job, scratch, child, &part.pool->pool(), progress).tree;
        part.grids = job.grids_visited();
        part.scratch_used = job.scratch_used();
    }

    TreeOutcome run(GridConversion& job, std::vector<std::uint32_t>& scratch, unsigned child, NodePool* pool,
                    Progress* progress) {
        require_converted(job.begin(solid_, options_, scratch.data(),
                                    static_cast<std::uint32_t>(scratch.size()), pool,
                                    GridOptions{most_grid_levels, root_octant.child(child)}));
        while (job.step(1)) {
            if (progress != nullptr) progress->show(done_ + (job.decided_volume() >> 20), passes_volume);
        }
        done_ += volume_at(1) >> 20;
        const TreeOutcome outcome = job.finish();
        require_converted(outcome.status);
        return outcome;
    }

    static constexpr std::uint64_t passes_volume = 2 * (root_volume >> 20);

    const CheckedSolid& solid_;
    ConvertOptions options_;
    Progress& progress_;
    std::array<Part, 8> parts_;
    std::atomic<unsigned> next_{0};
    std::atomic<std::uint64_t> done_{0}; ///< volume of the passes over parts that are over
    std::mutex failing_;
    std::exception_ptr failure_;
};

// Builds the root over its children, whose pools are the first part of this one, one behind the other.
class Joint {
  public:
    explicit Joint(NodePool& pool) : pool_(pool) { builder_.begin(&pool); }

    void add(unsigned child, const Octree& tree) {
        const NodeIndex by = static_cast<NodeIndex>(pool_.used());
        const NodePool& from = *tree.pool;
        for (std::uint32_t node = 0; node < from.used(); ++node) append(from.at(node), by);
        if (tree.top.is_uniform()) {
            builder_.leaf(child, tree.top.colour(0));
        } else {
            builder_.graft(child, moved(tree.top, by));
        }
    }

    TreeOutcome finish(int depth) {
        builder_.close();
        return builder_.finish(depth);
    }

  private:
    static Node moved(const Node& node, NodeIndex by) {
        return Node::of(node.may, node.must,
                        node.grey() == 0 ? node.first() : static_cast<NodeIndex>(node.first() + by));
    }
    void append(const Node& node, NodeIndex by) {
        const Node copy = moved(node, by);
        NodeIndex first = 0;
        static_cast<void>(pool_.append(&copy, 1, first)); // there is room for all
    }

    NodePool& pool_;
    TreeBuilder builder_;
};

} // namespace

Converted convert_octants_apart(const CheckedSolid& solid, const ConvertOptions& options, unsigned threads,
                                Progress& progress) {
    const Stopwatch watch;
    Crew crew(solid, options, progress);
    std::array<Part, 8>& parts = crew.work(std::min(threads, 8U));
    std::uint64_t nodes = 8; // the root's children
    std::uint64_t grids = 0;
    std::uint64_t words = 0;
    for (const Part& part : parts) {
        nodes += part.nodes;
        grids += part.grids;
        words = std::max<std::uint64_t>(words, part.scratch_used);
    }
    auto pool = std::make_unique<HostPool>(nodes);
    const auto joint = std::make_unique<Joint>(pool->pool());
    for (unsigned child = 0; child < 8; ++child) {
        joint->add(child, parts[child].tree);
        parts[child].pool.reset();
    }
    const TreeOutcome outcome = joint->finish(options.depth);
    const double seconds = watch.seconds();
    const std::uint64_t memory = threads * (sizeof(GridConversion) + 4 * words) + 2 * sizeof(Node) * nodes;
    return {std::move(pool), outcome.tree, seconds, StageCounts{}, grids, memory, {{"scratch_words", words}}};
}

} // namespace osem::host
