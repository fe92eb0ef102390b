// How expressions are refused, stepped through, and what happens when memory runs out or a stream is damaged.
#include <gtest/gtest.h>

#include <vector>

#include "osem/csg.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

namespace {

using Tokens = std::vector<CsgToken>;

const CsgToken a = CsgToken::of(0U);
const CsgToken b = CsgToken::of(1U);
const CsgToken unite = CsgToken::of(Operator::unite);
const CsgToken subtract = CsgToken::of(Operator::subtract);
const CsgToken complement_token = CsgToken::complement();

struct Verdict {
    Status status;
    std::uint32_t where;
};

Verdict verdict_on(const Tokens& tokens, std::uint32_t operand_count) {
    CsgExpression expression;
    std::uint32_t where = 12345;
    const Status status =
        expression.begin(tokens.data(), static_cast<std::uint32_t>(tokens.size()), operand_count, where);
    return {status, where};
}

void expect_refused(const Tokens& tokens, std::uint32_t operand_count, Status status, std::uint32_t where) {
    const Verdict verdict = verdict_on(tokens, operand_count);
    EXPECT_EQ(verdict.status, status);
    EXPECT_EQ(verdict.where, where);
}

// a + a + ... with `count` tokens, which has to be odd.
Tokens long_sum(std::size_t count) {
    Tokens tokens = {a};
    while (tokens.size() < count) {
        tokens.push_back(a);
        tokens.push_back(unite);
    }
    return tokens;
}

TEST(CsgExpression, RefusesWhatIsNotWellFormedAndSaysWhere) {
    expect_refused({}, 2, Status::expression_invalid, 0);
    expect_refused({a, unite}, 2, Status::expression_invalid, 1);
    expect_refused({complement_token, a}, 2, Status::expression_invalid, 0);
    expect_refused({a, b}, 2, Status::expression_invalid, 2);
    expect_refused({a, b, unite, subtract}, 2, Status::expression_invalid, 3);
    expect_refused({a, b, unite}, 1, Status::expression_invalid, 1);
    expect_refused({a, CsgToken{static_cast<CsgTokenKind>(3), 0, Operator::unite}}, 1,
                   Status::expression_invalid, 1);
    expect_refused({a, b, CsgToken::of(static_cast<Operator>(4))}, 2, Status::expression_invalid, 2);
    EXPECT_EQ(verdict_on({a, b, unite, complement_token}, 2).status, Status::ok);
}

TEST(CsgExpression, RefusesWhatIsPastTheBounds) {
    EXPECT_EQ(verdict_on(long_sum(csg_most_tokens - 1), 1).status, Status::ok);
    Tokens longest = long_sum(csg_most_tokens - 1);
    longest.push_back(complement_token);
    ASSERT_EQ(longest.size(), csg_most_tokens);
    EXPECT_EQ(verdict_on(longest, 1).status, Status::ok);
    expect_refused(long_sum(csg_most_tokens + 1), 1, Status::expression_too_large, csg_most_tokens);
    expect_refused({a}, csg_most_operands + 1, Status::expression_too_large, 1);
    Tokens repeats = {a};
    for (unsigned operand = 0; operand <= csg_most_repeated; ++operand) {
        if (operand > 0) repeats.insert(repeats.end(), {CsgToken::of(operand), unite});
        repeats.insert(repeats.end(), {CsgToken::of(operand), unite});
    }
    const auto last = static_cast<std::uint32_t>(repeats.size() - 2);
    expect_refused(repeats, csg_most_operands, Status::expression_too_large, last);
    repeats.resize(repeats.size() - 2);
    EXPECT_EQ(verdict_on(repeats, csg_most_operands).status, Status::ok);
}

// An octahedron less a random tree that is read from a stream.
class Work {
  public:
    explicit Work(std::uint32_t seed)
        : solid_(octahedron_solid({Point{{500001, 500001, 400001}}, 330001})), faces_(solid_.face_count()),
          tree_(planted(random_grid(3, seed, three_colours), *pool)), bytes_(written(tree_, StreamHeader{})) {
    }

    CsgFault begin(CsgConversion& job, NodePool* result, const CsgOptions& options) {
        operands_.clear();
        operands_.emplace_back(solid_operand_);
        operands_.emplace_back(stream_operand_);
        return job.begin(tokens_.data(), 3, operands_.data(), 2, options, result);
    }
    CsgOutcome whole(NodePool* result) {
        CsgConversion job;
        const CsgFault fault = begin(job, result, options());
        if (fault.status != Status::ok) return {{fault.status, 0, 0, tree_}, fault};
        while (job.step(1000)) {
        }
        return job.finish();
    }
    CsgOptions options() const {
        CsgOptions options;
        options.depth = 4;
        return options;
    }
    Bytes& bytes() { return bytes_; }

    HeapPool pool{5000};

  private:
    SmallSolid solid_;
    std::vector<std::uint32_t> faces_;
    Octree tree_;
    Bytes bytes_;
    CsgSolid solid_operand_{solid_.checked(), WindingRule::nonzero, faces_.data(), solid_.face_count()};
    CsgStream stream_operand_{source_of(bytes_)};
    Tokens tokens_{a, b, subtract};
    std::vector<CsgOperand> operands_;
};

TEST(CsgWork, StepsOfAnySizeGiveTheSameTree) {
    Work work(7);
    HeapPool whole_pool(5000);
    const CsgOutcome whole = work.whole(&*whole_pool);
    ASSERT_EQ(whole.built.status, Status::ok);
    CsgConversion job; // used again, it counts anew
    for (const std::uint32_t budget : {1U, 2U, 3U, 7U, 100000U}) {
        HeapPool pool(5000);
        ASSERT_EQ(work.begin(job, &*pool, work.options()).status, Status::ok);
        std::uint64_t volume = 0;
        std::uint64_t visits = 0;
        bool more = true;
        while (more) {
            more = job.step(budget);
            EXPECT_GE(job.decided_volume(), volume);
            EXPECT_LE(job.octants_visited(), visits + budget);
            volume = job.decided_volume();
            visits = job.octants_visited();
        }
        EXPECT_EQ(volume, root_volume);
        const CsgOutcome outcome = job.finish();
        ASSERT_EQ(outcome.built.status, Status::ok);
        EXPECT_TRUE(same_leaves(outcome.built.tree, whole.built.tree));
        EXPECT_EQ(pool.used_nodes().size(), whole_pool.used_nodes().size());
    }
}

TEST(CsgWork, APoolOfAnySizeIsEnoughOrIsAsBefore) {
    Work work(8);
    const std::uint32_t needed = work.whole(nullptr).built.nodes_needed;
    ASSERT_GT(needed, 20U);
    for (std::uint32_t capacity = 0; capacity <= needed; ++capacity) {
        HeapPool pool(capacity + 3);
        pool.fill_to(3);
        const PoolImage before(pool);
        const CsgOutcome outcome = work.whole(&*pool);
        EXPECT_EQ(outcome.built.status, capacity < needed ? Status::pool_exhausted : Status::ok);
        EXPECT_EQ(outcome.fault.status, outcome.built.status);
        EXPECT_EQ(outcome.built.nodes_missing, needed - capacity);
        EXPECT_TRUE(capacity == needed || before.same_nodes(pool));
    }
}

TEST(CsgWork, WorkGivenUpLeavesThePoolAsBefore) {
    Work work(9);
    HeapPool pool(5000);
    CsgConversion job;
    ASSERT_EQ(work.begin(job, &*pool, work.options()).status, Status::ok);
    job.step(40);
    EXPECT_EQ(job.finish().built.status, Status::unfinished);
    EXPECT_EQ(pool->used(), 0U);
    CsgConversion never_begun;
    EXPECT_EQ(never_begun.finish().built.status, Status::unfinished);
}

TEST(CsgWork, ADamagedStreamIsNamedWithItsByte) {
    Work work(10);
    for (std::size_t at = 0; at < work.bytes().size(); ++at) {
        work.bytes()[at] = static_cast<std::uint8_t>(work.bytes()[at] ^ 0x10U);
        HeapPool pool(5000);
        const CsgOutcome outcome = work.whole(&*pool);
        StreamReader reader;
        const StreamOutcome read = read_stream(reader, work.bytes(), nullptr);
        EXPECT_NE(outcome.built.status, Status::ok) << "byte " << at;
        EXPECT_EQ(outcome.built.status, read.built.status) << "byte " << at;
        EXPECT_EQ(outcome.fault.operand, 1U) << "byte " << at;
        EXPECT_EQ(outcome.fault.offset, read.offset) << "byte " << at;
        EXPECT_EQ(pool->used(), 0U) << "byte " << at;
        work.bytes()[at] = static_cast<std::uint8_t>(work.bytes()[at] ^ 0x10U);
    }
    EXPECT_EQ(work.whole(nullptr).built.status, Status::ok);
}

TEST(CsgWork, DepthsAndScratchThatDoNotFitAreRefused) {
    Work work(11);
    CsgConversion job;
    CsgOptions options;
    for (const int depth : {0, 21}) {
        options.depth = depth;
        const CsgFault fault = work.begin(job, nullptr, options);
        EXPECT_EQ(fault.status, Status::depth_out_of_range);
        EXPECT_EQ(fault.operand, 2U);
    }
    options.depth = 20;
    options.leaves = LeafRule::centre;
    EXPECT_EQ(work.begin(job, nullptr, options).status, Status::depth_out_of_range);
    options.depth = 2; // the stream's tree is of depth 3
    const CsgFault too_deep = work.begin(job, nullptr, options);
    EXPECT_EQ(too_deep.status, Status::depth_out_of_range);
    EXPECT_EQ(too_deep.operand, 1U);

    const SmallSolid solid = octahedron_solid({Point{{500001, 500001, 400001}}, 330001});
    std::vector<std::uint32_t> faces(solid.face_count());
    CsgSolid short_of_scratch(solid.checked(), WindingRule::nonzero, faces.data(), solid.face_count() - 1);
    const CsgOperand operand(short_of_scratch);
    const CsgFault fault = job.begin(&a, 1, &operand, 1, work.options(), nullptr);
    EXPECT_EQ(fault.status, Status::scratch_too_small);
    EXPECT_EQ(fault.operand, 0U);
}

// The state of a stream or a solid serves one walk: twice the same object would be out of step.
TEST(CsgWork, OneObjectAsTwoOperandsIsRefused) {
    HeapPool pool(1000);
    const Octree tree = planted(random_grid(3, 12, three_colours), *pool);
    const Bytes bytes = written(tree, StreamHeader{});
    CsgStream stream(source_of(bytes));
    CsgTree other(tree);
    const CsgOperand operands[] = {other, stream, stream};
    const Tokens tokens = {a, b, subtract};
    CsgConversion job;
    const CsgFault fault = job.begin(tokens.data(), 3, operands, 3, CsgOptions(), nullptr);
    EXPECT_EQ(fault.status, Status::operand_repeated);
    EXPECT_EQ(fault.operand, 2U);
    EXPECT_EQ(job.begin(tokens.data(), 3, operands, 2, CsgOptions(), nullptr).status, Status::ok);
}

TEST(CsgWork, AFailedBeginForgetsTheWalkBefore) {
    Work work(13);
    HeapPool pool(2);
    CsgConversion job;
    ASSERT_EQ(work.begin(job, &*pool, work.options()).status, Status::ok);
    while (job.step(1000)) {
    }
    EXPECT_EQ(job.finish().built.status, Status::pool_exhausted);
    CsgOptions too_deep;
    too_deep.depth = 21;
    EXPECT_EQ(work.begin(job, &*pool, too_deep).status, Status::depth_out_of_range);
    EXPECT_EQ(job.finish().built.status, Status::unfinished);
}

// In begin and by the function that does all at once.
TEST(CsgWork, WhatIsRefusedIsNamedInTheOutcome) {
    HeapPool pool(1000);
    const Octree tree = planted(random_grid(3, 14, three_colours), *pool);
    CsgTree first(tree);
    CsgTree second(tree);
    const CsgOperand operands[] = {first, second, first};
    CsgConversion job;
    const Tokens malformed = {a, unite};
    CsgOutcome outcome = convert_expression(job, malformed.data(), 2, operands, 2, CsgOptions(), nullptr);
    EXPECT_EQ(outcome.built.status, Status::expression_invalid);
    EXPECT_EQ(outcome.fault.status, Status::expression_invalid);
    EXPECT_EQ(outcome.fault.token, 1U);

    const Tokens good = {a, b, unite};
    outcome = convert_expression(job, good.data(), 3, operands, 3, CsgOptions(), nullptr);
    EXPECT_EQ(outcome.built.status, Status::operand_repeated);
    EXPECT_EQ(outcome.fault.operand, 2U) << "not beside the one that it repeats";

    CsgOptions shallow;
    shallow.depth = 2; // the trees are of depth 3
    outcome = convert_expression(job, good.data(), 3, operands, 2, shallow, nullptr);
    EXPECT_EQ(outcome.built.status, Status::depth_out_of_range);
    EXPECT_EQ(outcome.fault.operand, 0U);
    shallow.depth = 3;
    EXPECT_EQ(convert_expression(job, good.data(), 3, operands, 2, shallow, nullptr).built.status,
              Status::ok);
}

// Whichever of two streams is damaged, and the first of them where both are.
TEST(CsgWork, TheFirstStreamAtFaultIsNamed) {
    HeapPool pool(1000);
    const Octree tree = planted(random_grid(3, 15, three_colours), *pool);
    const Bytes good = written(tree, StreamHeader{});
    Bytes bad = good;
    bad[bad.size() - 1] = static_cast<std::uint8_t>(bad[bad.size() - 1] ^ 1U); // seen at the end
    const Tokens tokens = {a, b, unite};
    for (unsigned damaged = 1; damaged < 4; ++damaged) {
        CsgStream first(memory_source((damaged & 1U) != 0 ? bad.data() : good.data(), good.size()));
        CsgStream second(memory_source((damaged & 2U) != 0 ? bad.data() : good.data(), good.size()));
        const CsgOperand operands[] = {first, second};
        CsgConversion job;
        const CsgOutcome outcome =
            convert_expression(job, tokens.data(), 3, operands, 2, CsgOptions(), &*pool);
        EXPECT_EQ(outcome.built.status, Status::stream_payload_damaged);
        EXPECT_EQ(outcome.fault.operand, (damaged & 1U) != 0 ? 0U : 1U);
    }
}

TEST(CsgWork, ThePoolIsKnownToHaveRunOut) {
    Work work(16);
    const std::uint32_t needed = work.whole(nullptr).built.nodes_needed;
    for (const std::uint32_t capacity : {needed - 1, needed}) {
        HeapPool pool(capacity);
        CsgConversion job;
        ASSERT_EQ(work.begin(job, &*pool, work.options()).status, Status::ok);
        EXPECT_FALSE(job.exhausted());
        while (job.step(1)) {
        }
        EXPECT_EQ(job.exhausted(), capacity < needed);
    }
}

} // namespace

} // namespace osem::tests
