// Booleans from stream to stream, and questions to streams.
#include "osem/stream_boolean.hpp"
#include "osem/stream_query.hpp"

#include "records.hpp"
#include "topics.hpp"

#include "stream/crc.hpp"

namespace osem::cross {

namespace {

struct Memory {
    std::uint8_t* bytes;
    std::size_t count;
    std::size_t capacity;

    Source source() const { return memory_source(bytes, count); }
};

bool to_memory(void* context, const std::uint8_t* bytes, std::size_t count) {
    Memory& memory = *static_cast<Memory*>(context);
    if (count > memory.capacity - memory.count) return false;
    for (std::size_t i = 0; i < count; ++i) memory.bytes[memory.count++] = bytes[i];
    return true;
}

Memory read_stream(Reader& reader, Arena& arena) {
    const std::uint32_t size = reader.u32();
    const Memory memory = {arena.take<std::uint8_t>(size), size, size};
    for (std::uint32_t i = 0; memory.bytes != nullptr && i < size; ++i) memory.bytes[i] = reader.u8();
    return memory;
}

struct Work {
    StreamCombination* job;
    StreamCursor* cursor;
    Memory operands[2];
};

StreamCombinationOutcome run(const Work& work, std::uint8_t operation, Memory& result) {
    const Sink sink = {to_memory, &result};
    const Source a = work.operands[0].source();
    if (operation == operation_complement) {
        work.job->begin_complement(a, sink);
    } else {
        work.job->begin(static_cast<Operator>(operation), a, work.operands[1].source(), sink);
    }
    while (work.job->step(5)) {
    }
    return work.job->finish();
}

void compare_cursor(Reader& reader, Report& report, std::uint32_t leaves, StreamCursor& cursor,
                    const Source& source) {
    report.expect("status of a walk", static_cast<int>(Status::ok), static_cast<int>(cursor.begin(source)));
    std::uint32_t seen = 0;
    for (; !cursor.done(); cursor.next()) {
        if (cursor.colour() == Colour::grey || seen++ >= leaves) continue;
        report.expect("leaf (4 * level + colour)", reader.u8(), encoded(cursor.level(), cursor.colour()));
    }
    reader.skip(seen < leaves ? leaves - seen : 0);
    report.expect("leaves walked", leaves, seen);
    report.expect("status at the end of a walk", static_cast<int>(Status::ok),
                  static_cast<int>(cursor.status()));
}

void compare_stream(Reader& reader, Report& report, const TreeTruth& truth, const Work& work,
                    const Memory& result) {
    const Source source = result.source();
    report.expect("CRC of the stream", truth.stream_crc, crc_append(0, result.bytes, result.count));
    const StreamMeasures measured = measure(source);
    const StreamDigest digested = digest(source);
    report.expect("status of measures", static_cast<int>(Status::ok), static_cast<int>(measured.status));
    report.expect("status of a digest", static_cast<int>(Status::ok), static_cast<int>(digested.status));
    compare_measures(report, truth, measured.measures, digested.digest);
    compare_cursor(reader, report, truth.leaves, *work.cursor, source);
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        const PointQuery query = read_query(reader);
        compare_query(report, query, leaf_at(source, query.cell).point);
    }
}

void replay_row(Reader& reader, Arena& arena, Report& report, const Work& work) {
    const std::uint8_t operation = reader.u8();
    const bool same = reader.u8() != 0;
    const TreeTruth truth = read_tree_truth(reader);
    const auto size = static_cast<std::size_t>(stream_size(truth.leaves == 1 ? 0 : truth.nodes));
    const ArenaScope scope(arena);
    Memory result = {arena.take<std::uint8_t>(size), 0, size};
    if (result.bytes == nullptr) {
        report.too_large();
        skip_tree(reader, truth);
        return;
    }
    report.begin_case();
    const StreamCombinationOutcome outcome = run(work, operation, result);
    if (!report.expect("status of the operation", static_cast<int>(Status::ok),
                       static_cast<int>(outcome.status))) {
        skip_tree(reader, truth);
        return;
    }
    compare_stream(reader, report, truth, work, result);
    const StreamComparison comparison = same_leaves(result.source(), work.operands[0].source());
    report.expect("status of a comparison", static_cast<int>(Status::ok),
                  static_cast<int>(comparison.status));
    report.expect("same leaves as the first operand", same ? 1 : 0, comparison.same ? 1 : 0);
}

// The damaged operand is named, and nothing is written.
void replay_damage(Reader& reader, Report& report, const Work& work) {
    report.begin_case();
    const std::uint8_t operand = reader.u8();
    std::uint8_t& byte = work.operands[operand & 1U].bytes[reader.u32()];
    const unsigned bit = 1U << reader.u8();
    Memory nothing = {nullptr, 0, 0};
    byte = static_cast<std::uint8_t>(byte ^ bit);
    const StreamCombinationOutcome outcome = run(work, static_cast<std::uint8_t>(Operator::unite), nothing);
    byte = static_cast<std::uint8_t>(byte ^ bit);
    const bool refused = outcome.status != Status::ok && outcome.status != Status::sink_refused;
    report.expect("whether the damage is refused", 1, refused ? 1 : 0);
    report.expect("damaged operand", operand, outcome.operand);
}

} // namespace

bool replay_stream(Reader& reader, Arena& arena, Report& report) {
    Work work = {arena.take<StreamCombination>(1), arena.take<StreamCursor>(1), {}};
    if (work.job == nullptr || work.cursor == nullptr) return false;
    for (Memory& operand : work.operands) {
        operand = read_stream(reader, arena);
        if (operand.bytes == nullptr) return false;
    }
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_row(reader, arena, report, work);
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_damage(reader, report, work);
    return true;
}

} // namespace osem::cross
