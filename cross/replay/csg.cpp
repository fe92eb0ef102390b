// Expressions over solids, trees and streams.
#include "osem/csg.hpp"

#include "leaf_planter.hpp"
#include "records.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

constexpr std::uint8_t most_operands = 4;

// Room for an object that is made once what it is made of has been read.
template <class T>
struct Room {
    alignas(T) unsigned char bytes[sizeof(T)];

    template <class... Arguments>
    T* make(const Arguments&... arguments) {
        return ::new (static_cast<void*>(bytes)) T(arguments...);
    }
};

// One operand of a record: a solid, or a tree and the same tree as a stream.
struct Operand {
    CsgSolid* solid;
    CsgTree* tree;
    CsgStream* stream;

    CsgOperand as(bool streamed) const {
        if (solid != nullptr) return *solid;
        return streamed ? CsgOperand(*stream) : CsgOperand(*tree);
    }
};

struct Memory {
    std::uint8_t* bytes;
    std::size_t count;
};

bool to_memory(void* context, const std::uint8_t* bytes, std::size_t count) {
    Memory& memory = *static_cast<Memory*>(context);
    for (std::size_t i = 0; i < count; ++i) memory.bytes[memory.count++] = bytes[i];
    return true;
}

bool read_solid_operand(Reader& reader, Arena& arena, WindingRule winding, Operand& operand) {
    Solid solid = {};
    if (!read_solid(reader, arena, solid)) return false;
    auto* const faces = arena.take<std::uint32_t>(convert_scratch(solid));
    auto* const room = arena.take<Room<CsgSolid>>(1);
    if (faces == nullptr || room == nullptr) return false;
    operand.solid = room->make(CheckedSolid::vouched(solid), winding, faces, convert_scratch(solid));
    return true;
}

bool read_tree_operand(Reader& reader, Arena& arena, Operand& operand) {
    const std::uint8_t depth = reader.u8();
    const std::uint32_t leaves = reader.u32();
    const std::uint32_t nodes = nodes_of(leaves);
    Node* const memory = take_nodes(arena, nodes);
    auto* const pool_room = arena.take<Room<NodePool>>(1);
    auto* const tree_room = arena.take<Room<CsgTree>>(1);
    auto* const stream_room = arena.take<Room<CsgStream>>(1);
    Memory stream = {arena.take<std::uint8_t>(static_cast<std::size_t>(stream_size(nodes))), 0};
    if (memory == nullptr || pool_room == nullptr || tree_room == nullptr) return false;
    if (stream_room == nullptr || stream.bytes == nullptr) return false;
    const ArenaScope scope(arena); // the builder's memory is given back
    auto* const builder = arena.take<TreeBuilder>(1);
    if (builder == nullptr) return false;
    NodePool* const pool = pool_room->make(memory, nodes);
    const Octree tree = plant_leaves(reader, depth, leaves, *builder, *pool).tree;
    if (write_stream(tree, StreamHeader{}, Sink{to_memory, &stream}) != Status::ok) return false;
    operand.tree = tree_room->make(tree);
    operand.stream = stream_room->make(memory_source(stream.bytes, stream.count));
    return true;
}

CsgToken token_of(std::uint8_t byte) {
    if (byte == token_complement) return CsgToken::complement();
    if (byte >= token_combine) return CsgToken::of(static_cast<Operator>(byte - token_combine));
    return CsgToken::of(unsigned{byte});
}

// A conversion, and what it is of.
struct Work {
    CsgConversion* job;
    CsgToken* tokens;
    Operand operands[most_operands];
    std::uint8_t operand_count;
    CsgOptions options;
    NodePool* pool;
};

CsgOutcome converted(const Work& work, std::uint8_t token_count, bool streamed, NodePool* pool) {
    const CsgOperand operands[most_operands] = {work.operands[0].as(streamed), work.operands[1].as(!streamed),
                                                work.operands[2].as(streamed),
                                                work.operands[3].as(!streamed)};
    return convert_expression(*work.job, work.tokens, token_count, operands, work.operand_count, work.options,
                              pool);
}

// Trees are streams in every other row, and the other way about when the nodes are counted.
void replay_row(Reader& reader, Report& report, const Work& work, bool streamed) {
    report.begin_case();
    const std::uint8_t token_count = reader.u8();
    for (std::uint8_t i = 0; i < token_count; ++i) work.tokens[i] = token_of(reader.u8());
    const TreeTruth truth = read_tree_truth(reader);
    const CsgOutcome counted = converted(work, token_count, !streamed, nullptr);
    report.expect("nodes counted", truth.pool_nodes(), counted.built.nodes_needed);
    const CsgOutcome outcome = converted(work, token_count, streamed, work.pool);
    if (!report.expect("status of an expression", static_cast<int>(Status::ok),
                       static_cast<int>(outcome.built.status))) {
        skip_tree(reader, truth);
        return;
    }
    compare_tree(reader, report, truth, outcome.built.tree, work.options.leaves);
    work.pool->roll_back(0);
}

} // namespace

bool replay_csg(Reader& reader, Arena& arena, Report& report) {
    const ConvertOptions options = read_options(reader);
    Work work = {nullptr, nullptr, {}, reader.u8(), CsgOptions{options.depth, options.leaves}, nullptr};
    if (work.operand_count != most_operands) return false;
    for (Operand& operand : work.operands) {
        const bool read = reader.u8() == operand_solid
                              ? read_solid_operand(reader, arena, options.winding, operand)
                              : read_tree_operand(reader, arena, operand);
        if (!read) return false;
    }
    const std::uint32_t nodes = reader.u32();
    Node* const memory = take_nodes(arena, nodes);
    work.job = arena.take<CsgConversion>(1);
    work.tokens = arena.take<CsgToken>(csg_most_tokens);
    if (memory == nullptr || work.job == nullptr || work.tokens == nullptr) return false;
    NodePool pool(memory, nodes);
    work.pool = &pool;
    const std::uint8_t rows = reader.u8();
    for (std::uint8_t row = 0; row < rows; ++row) replay_row(reader, report, work, row % 2 == 1);
    return true;
}

} // namespace osem::cross
