#include "commands/octants_apart.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "commands/estimate.hpp"
#include "commands/stopwatch.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

struct Part {
    std::shared_ptr<HostPool> pool; ///< it shares it with others
    NodeIndex first = 0;            ///< of its nodes in there
    Octree tree = {};
    std::uint64_t grids = 0;
    std::uint32_t nodes = 0;
    std::uint32_t scratch_used = 0;
};

// The children of the root, and the threads that take one after the other, those first that are likely to
// take longest. The thread that makes it is one of them, and shows how far all are.
class Crew {
  public:
    Crew(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress)
        : solid_(solid), options_(options), progress_(progress) {
        const std::array<Estimate, 8> estimates = estimate_children(solid.view(), options.depth);
        std::sort(order_.begin(), order_.end(),
                  [&](unsigned a, unsigned b) { return estimates[a].effort() > estimates[b].effort(); });
        Estimate all;
        for (const Estimate& part : estimates) all.add(part);
        nodes_ = all.nodes();
    }

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
            const std::shared_ptr<HostPool> pool = roomy_pool(nodes_);
            for (unsigned next = next_++; next < parts_.size(); next = next_++) {
                convert(*job, scratch, order_[next], pool, progress);
                done_ += volume_at(1) >> 20;
            }
        } catch (...) {
            const std::lock_guard<std::mutex> lock(failing_);
            failure_ = std::current_exception();
            next_ = static_cast<unsigned>(parts_.size()); // the others end as well
        }
    }

    void convert(GridConversion& job, std::vector<std::uint32_t>& scratch, unsigned child,
                 std::shared_ptr<HostPool> pool, Progress* progress) {
        Part& part = parts_[child];
        const TreeOutcome outcome = run_with_room(pool, [&](NodePool& nodes) {
            part.first = static_cast<NodeIndex>(nodes.used());
            return run(job, scratch, child, nodes, progress);
        });
        require_converted(outcome.status);
        part.pool = std::move(pool);
        part.tree = outcome.tree;
        part.grids = job.grids_visited();
        part.nodes = outcome.nodes_needed;
        part.scratch_used = job.scratch_used();
    }

    TreeOutcome run(GridConversion& job, std::vector<std::uint32_t>& scratch, unsigned child, NodePool& pool,
                    Progress* progress) {
        require_converted(job.begin(solid_, options_, scratch.data(),
                                    static_cast<std::uint32_t>(scratch.size()), &pool,
                                    GridOptions{most_grid_levels, root_octant.child(child)}));
        while (job.step(1)) {
            if (progress != nullptr) {
                progress->show(done_ + (job.decided_volume() >> 20), root_volume >> 20);
            }
        }
        return job.finish();
    }

    const CheckedSolid& solid_;
    ConvertOptions options_;
    Progress& progress_;
    std::uint64_t nodes_ = 0; ///< that all parts are likely to have
    std::array<unsigned, 8> order_{0, 1, 2, 3, 4, 5, 6, 7};
    std::array<Part, 8> parts_;
    std::atomic<unsigned> next_{0};
    std::atomic<std::uint64_t> done_{0}; ///< volume of the parts that are done
    std::mutex failing_;
    std::exception_ptr failure_;
};

// Builds the root over its children, whose nodes are the first part of this pool, one behind the other.
class Joint {
  public:
    explicit Joint(NodePool& pool) : pool_(pool) { builder_.begin(&pool); }

    void add(unsigned child, const Part& part) {
        const auto by = static_cast<NodeIndex>(pool_.used() - part.first);
        const Node* from = part.nodes == 0 ? nullptr : &part.tree.pool->at(part.first);
        for (std::uint32_t left = part.nodes; left != 0;) {
            const std::uint32_t count = std::min(left, static_cast<std::uint32_t>(together_.size()));
            for (std::uint32_t i = 0; i < count; ++i) together_[i] = moved(from[i], by);
            NodeIndex first = 0;
            static_cast<void>(pool_.append(together_.data(), count, first)); // there is room for all
            from += count;
            left -= count;
        }
        if (part.tree.top.is_uniform()) {
            builder_.leaf(child, part.tree.top.colour(0));
        } else {
            builder_.graft(child, moved(part.tree.top, by));
        }
    }

    TreeOutcome finish(int depth) {
        builder_.close();
        return builder_.finish(depth);
    }

  private:
    static Node moved(const Node& node, NodeIndex by) {
        return Node::of(node.may, node.must,
                        static_cast<NodeIndex>(node.first() + (node.grey() == 0 ? 0 : by)));
    }

    NodePool& pool_;
    TreeBuilder builder_;
    std::array<Node, 256> together_{};
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
        joint->add(child, parts[child]);
        parts[child].pool.reset();
    }
    const TreeOutcome outcome = joint->finish(options.depth);
    const double seconds = watch.seconds();
    const std::uint64_t memory = threads * (sizeof(GridConversion) + 4 * words) + 2 * sizeof(Node) * nodes;
    return {std::move(pool), outcome.tree, seconds, StageCounts{}, grids, memory, {{"scratch_words", words}}};
}

} // namespace osem::host
