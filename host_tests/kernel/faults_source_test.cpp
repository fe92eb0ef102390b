// Whatever reads a source, with each of its reads refused in turn (after part of the bytes was given), and
// with sources of every size that is too short or too long: the operand and the byte are named, and another
// run on sources that answer gives the result, which is worked out cell by cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "osem/csg.hpp"
#include "osem/stream_boolean.hpp"
#include "osem/stream_query.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/effort.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr std::uint8_t garbage = 0x5a;

// Bytes that can be had until a read is to be refused; that one leaves half of its bytes, and nonsense.
struct Flaky {
    Bytes bytes;
    std::uint64_t size = 0; ///< as the source states it
    std::size_t room = SIZE_MAX;
    std::size_t reads = 0;
    std::uint64_t refused_at = 0;
    bool refused = false;

    explicit Flaky(Bytes all) : bytes(std::move(all)), size(bytes.size()) {}
    Source source() { return {read, this, size}; }

  private:
    static bool read(void* context, std::uint64_t offset, std::uint8_t* to, std::size_t count) {
        auto& self = *static_cast<Flaky*>(context);
        EXPECT_FALSE(self.refused) << "a read after a refusal";
        EXPECT_LE(offset + count, self.size);
        self.refused = self.reads++ == self.room;
        const std::size_t given = self.refused ? count / 2 : count;
        std::fill_n(to, count, garbage);
        for (std::size_t i = 0; i < given && offset + i < self.bytes.size(); ++i) {
            to[i] = self.bytes[static_cast<std::size_t>(offset) + i];
        }
        if (self.refused) self.refused_at = offset;
        return !self.refused;
    }
};

struct Answer {
    Status status;
    std::uint32_t operand;
    std::uint64_t offset;
};

// `run` asks, and looks at what an ok answer says. One that reads no more than it needs is `early`.
struct SourceJob {
    std::string name;
    std::size_t sources;
    std::function<Answer(std::vector<Flaky>&, std::uint32_t budget)> run;
    std::size_t strided_from = SIZE_MAX; ///< from this read on only some are refused, there being so many
};
void PrintTo(const SourceJob& job, std::ostream* out) { *out << job.name; }

DenseGrid grid_at(std::size_t i) { return random_grid(4, 31 + static_cast<std::uint32_t>(i), three_colours); }

std::vector<Flaky> sources_of(const SourceJob& job) {
    std::vector<Flaky> sources;
    for (std::size_t i = 0; i < job.sources; ++i) sources.emplace_back(stream_of(grid_at(i)));
    return sources;
}

bool collect(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& all = *static_cast<Bytes*>(context);
    all.insert(all.end(), bytes, bytes + count);
    return true;
}

std::vector<SourceJob> query_jobs() {
    return {{"cursor", 1,
             [](std::vector<Flaky>& from, std::uint32_t) {
                 StreamCursor cursor;
                 cursor.begin(from[0].source());
                 std::vector<Colour> colours;
                 for (; !cursor.done(); cursor.next()) colours.push_back(cursor.colour());
                 if (cursor.status() == Status::ok) {
                     EXPECT_EQ(colours, preorder_colours(preorder_masks(grid_at(0))));
                 }
                 return Answer{cursor.status(), 0, cursor.offset()};
             }},
            {"point", 1,
             [](std::vector<Flaky>& from, std::uint32_t) {
                 const Point last = {{root_side - 1, root_side - 1, root_side - 1}};
                 const StreamPointOutcome outcome = leaf_at(from[0].source(), last);
                 if (outcome.point.status == Status::ok) {
                     EXPECT_EQ(outcome.point.leaf.colour, grid_at(0).at(last));
                 }
                 return Answer{outcome.point.status, 0, outcome.offset};
             }},
            {"measures", 1,
             [](std::vector<Flaky>& from, std::uint32_t) {
                 const StreamMeasures outcome = measure(from[0].source());
                 if (outcome.status == Status::ok) {
                     const DenseGrid grid = grid_at(0);
                     EXPECT_EQ(outcome.measures.nodes, preorder_masks(grid).size());
                     EXPECT_EQ(outcome.measures.inner_volume, grid.volume(Colour::black));
                 }
                 return Answer{outcome.status, 0, outcome.offset};
             }},
            {"digest", 1,
             [](std::vector<Flaky>& from, std::uint32_t) {
                 const StreamDigest outcome = digest(from[0].source());
                 if (outcome.status == Status::ok) {
                     EXPECT_EQ(outcome.digest, expected_digest(grid_at(0)));
                 }
                 return Answer{outcome.status, 0, outcome.offset};
             },
             400},
            {"comparison_with_a_tree", 1, [](std::vector<Flaky>& from, std::uint32_t) {
                 HeapPool pool(4000);
                 const Octree tree = planted(grid_at(0), *pool);
                 const StreamComparison outcome = same_leaves(from[0].source(), tree);
                 if (outcome.status == Status::ok) {
                     EXPECT_TRUE(outcome.same);
                 }
                 return Answer{outcome.status, 0, outcome.offset};
             }}};
}

std::vector<SourceJob> combination_jobs() {
    const auto job = std::make_shared<StreamCombination>();
    const auto run = [job](Status begun, const Bytes& to, const Effort& effort, const DenseGrid& expected) {
        if (begun == Status::ok) drive(*job, effort);
        const StreamCombinationOutcome outcome = job->finish();
        if (begun != Status::ok) {
            EXPECT_EQ(outcome.status, begun);
        }
        if (outcome.status == Status::ok) {
            EXPECT_EQ(to, stream_of(expected));
        }
        return Answer{outcome.status, outcome.operand, outcome.offset};
    };
    std::vector<SourceJob> jobs;
    for (const Operator op :
         {Operator::unite, Operator::intersect, Operator::subtract, Operator::exclusive_or}) {
        jobs.push_back(
            {"operator_" + std::to_string(static_cast<int>(op)), 2,
             [=](std::vector<Flaky>& from, std::uint32_t budget) {
                 Bytes to;
                 const Status begun = job->begin(op, from[0].source(), from[1].source(), Sink{collect, &to});
                 return run(begun, to, {budget}, combined(op, grid_at(0), grid_at(1)));
             }});
    }
    jobs.push_back({"complement", 1, [=](std::vector<Flaky>& from, std::uint32_t budget) {
                        Bytes to;
                        const Status begun = job->begin_complement(from[0].source(), Sink{collect, &to});
                        return run(begun, to, {budget}, complemented(grid_at(0)));
                    }});
    return jobs;
}

// a - (b ^ c) from three streams into a pool.
SourceJob expression_job() {
    const auto job = std::make_shared<CsgConversion>();
    return {"expression", 3, [job](std::vector<Flaky>& from, std::uint32_t budget) {
                const CsgToken tokens[] = {CsgToken::of(0U), CsgToken::of(1U), CsgToken::of(2U),
                                           CsgToken::of(Operator::exclusive_or),
                                           CsgToken::of(Operator::subtract)};
                CsgStream a(from[0].source());
                CsgStream b(from[1].source());
                CsgStream c(from[2].source());
                const CsgOperand operands[] = {a, b, c};
                CsgOptions options;
                options.depth = 4;
                HeapPool pool(5000);
                pool.fill_to(7);
                const PoolImage before(pool);
                CsgFault fault = job->begin(tokens, 5, operands, 3, options, &*pool);
                if (fault.status == Status::ok) {
                    drive(*job, {budget});
                    const CsgOutcome outcome = job->finish();
                    fault = outcome.fault;
                    EXPECT_EQ(outcome.built.status, fault.status);
                    if (fault.status == Status::ok) {
                        EXPECT_EQ(digest(outcome.built.tree),
                                  expected_digest(
                                      combined(Operator::subtract, grid_at(0),
                                               combined(Operator::exclusive_or, grid_at(1), grid_at(2)))));
                    }
                }
                if (fault.status != Status::ok) {
                    EXPECT_TRUE(before.same_nodes(pool));
                }
                return Answer{fault.status, fault.operand, fault.offset};
            }};
}

std::vector<SourceJob> source_jobs() {
    std::vector<SourceJob> jobs = query_jobs();
    const std::vector<SourceJob> combinations = combination_jobs();
    jobs.insert(jobs.end(), combinations.begin(), combinations.end());
    jobs.push_back(expression_job());
    return jobs;
}

class SourceFaults : public ::testing::TestWithParam<SourceJob> {
  protected:
    const SourceJob& of = GetParam();

    void expect_right(std::uint32_t budget) {
        std::vector<Flaky> sources = sources_of(of);
        ASSERT_EQ(of.run(sources, budget).status, Status::ok);
    }
};

TEST_P(SourceFaults, EveryReadMayBeRefused) {
    std::vector<Flaky> whole = sources_of(of);
    ASSERT_EQ(of.run(whole, UINT32_MAX).status, Status::ok);
    for (std::size_t operand = 0; operand < of.sources; ++operand) {
        ASSERT_GT(whole[operand].reads, 3U);
        for (std::size_t at = 0; at < whole[operand].reads; at += at < of.strided_from ? 1 : 97) {
            const std::uint32_t budget = step_budgets[at % step_budget_count];
            std::vector<Flaky> sources = sources_of(of);
            sources[operand].room = at;
            const Answer answer = of.run(sources, budget);
            ASSERT_EQ(answer.status, Status::source_failed) << "operand " << operand << ", read " << at;
            ASSERT_EQ(answer.operand, operand);
            ASSERT_EQ(answer.offset, sources[operand].refused_at);
            if (at % 16 == 0) {
                ASSERT_NO_FATAL_FAILURE(expect_right(budget));
            }
        }
    }
}

TEST_P(SourceFaults, EverySizeButTheRightOneIsRefused) {
    for (std::size_t operand = 0; operand < of.sources; ++operand) {
        std::vector<Flaky> sources = sources_of(of);
        const std::size_t whole = sources[operand].bytes.size();
        for (std::uint64_t size = 0; size < whole + 3; ++size) {
            if (size == whole) continue;
            sources[operand].size = size;
            sources[operand].bytes.resize(std::max<std::size_t>(whole, static_cast<std::size_t>(size)));
            const Answer answer = of.run(sources, 7);
            ASSERT_EQ(answer.status, size < whole ? Status::stream_truncated : Status::stream_trailing_bytes)
                << "operand " << operand << ", " << size << " of " << whole << " bytes";
            ASSERT_EQ(answer.operand, operand);
            ASSERT_EQ(answer.offset, std::min<std::uint64_t>(size, whole));
        }
    }
    expect_right(1);
}

INSTANTIATE_TEST_SUITE_P(All, SourceFaults, ::testing::ValuesIn(source_jobs()),
                         [](const auto& job) { return job.param.name; });

} // namespace

} // namespace osem::tests
