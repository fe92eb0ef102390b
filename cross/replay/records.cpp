#include "records.hpp"

#include "stream/crc.hpp"

namespace osem::cross {

namespace {

const Point* read_points(Reader& reader, Arena& arena, std::uint32_t count) {
    Point* points = arena.take<Point>(count);
    for (std::uint32_t i = 0; points != nullptr && i < count; ++i) points[i] = reader.point();
    return points;
}

const std::uint32_t* read_indices(Reader& reader, Arena& arena, std::uint32_t count) {
    auto* indices = arena.take<std::uint32_t>(count);
    for (std::uint32_t i = 0; indices != nullptr && i < count; ++i) indices[i] = reader.u32();
    return indices;
}

StreamHeader header_of(LeafRule rule) {
    StreamHeader header = {};
    header.leaf_rule = static_cast<std::uint8_t>(rule);
    for (int i = 0; i < 4; ++i) header.frame[i] = stream_frame[i];
    return header;
}

bool append_to_crc(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& crc = *static_cast<std::uint32_t*>(context);
    crc = crc_append(crc, bytes, count);
    return true;
}

bool feed_reader(void* context, const std::uint8_t* bytes, std::size_t count) {
    return static_cast<StreamReader*>(context)->feed(bytes, count) == Status::ok;
}

void compare_leaves(Reader& reader, Report& report, std::uint32_t leaves, const Octree& tree) {
    LeafWalk walk(tree);
    Leaf leaf = {};
    std::uint32_t seen = 0;
    for (; seen < leaves && walk.next(leaf); ++seen) {
        report.expect("leaf (4 * level + colour)", reader.u8(), encoded(leaf.octant.level, leaf.colour));
    }
    reader.skip(leaves - seen);
    const bool more = seen == leaves && walk.next(leaf);
    report.expect("leaves walked", leaves, more ? seen + 1 : seen);
}

} // namespace

bool read_solid(Reader& reader, Arena& arena, Solid& solid) {
    solid = Solid{};
    solid.vertex_count = reader.u32();
    solid.corner_count = reader.u32();
    const std::uint32_t rings = reader.u32();
    solid.face_count = reader.u32();
    const bool has_tables = reader.u8() != 0;
    solid.vertices = read_points(reader, arena, solid.vertex_count);
    if (solid.vertices == nullptr) return false;
    solid.corners = read_indices(reader, arena, solid.corner_count);
    if (solid.corners == nullptr || !has_tables) return solid.corners != nullptr;
    solid.ring_starts = read_indices(reader, arena, rings + 1);
    if (solid.ring_starts == nullptr) return false;
    solid.face_rings = read_indices(reader, arena, solid.face_count + 1);
    return solid.face_rings != nullptr;
}

ConvertOptions read_options(Reader& reader) {
    ConvertOptions options;
    options.depth = reader.u8();
    options.leaves = static_cast<LeafRule>(reader.u8());
    options.winding = static_cast<WindingRule>(reader.u8());
    return options;
}

TreeTruth read_tree_truth(Reader& reader) {
    TreeTruth truth = {};
    truth.nodes = reader.u32();
    truth.white_leaves = reader.u32();
    truth.black_leaves = reader.u32();
    truth.boundary_leaves = reader.u32();
    truth.inner_volume = reader.u64();
    truth.outer_volume = reader.u64();
    truth.digest = reader.u64();
    truth.stream_crc = reader.u32();
    truth.leaves = reader.u32();
    return truth;
}

void skip_tree(Reader& reader, const TreeTruth& truth) {
    reader.skip(truth.leaves);
    constexpr std::uint32_t query_size = 14;
    const std::uint32_t queries = reader.u8();
    reader.skip(queries * query_size);
}

void compare_measures(Report& report, const TreeTruth& truth, const Measures& found, std::uint64_t digest) {
    const auto expect = [&](const char* what, std::uint64_t expected, std::uint64_t value) {
        report.expect(what, static_cast<std::int64_t>(expected), static_cast<std::int64_t>(value));
    };
    expect("nodes", truth.nodes, found.nodes);
    expect("white leaves", truth.white_leaves, found.white_leaves);
    expect("black leaves", truth.black_leaves, found.black_leaves);
    expect("boundary leaves", truth.boundary_leaves, found.boundary_leaves);
    expect("inner volume", truth.inner_volume, found.inner_volume);
    expect("outer volume", truth.outer_volume, found.outer_volume);
    expect("digest", truth.digest, digest);
}

PointQuery read_query(Reader& reader) {
    const Point cell = reader.point();
    const auto status = static_cast<Status>(reader.u8());
    return PointQuery{cell, status, reader.u8()};
}

void compare_query(Report& report, const PointQuery& query, const PointOutcome& found) {
    if (!report.expect("status of leaf_at", static_cast<int>(query.status), static_cast<int>(found.status))) {
        return;
    }
    if (query.status != Status::ok) return;
    report.expect("leaf_at", query.leaf, encoded(found.leaf.octant.level, found.leaf.colour));
    const std::int32_t mask = -(root_side >> encoded_level(query.leaf));
    for (int axis = 0; axis < 3; ++axis) {
        report.expect("corner of leaf_at", query.cell.at[axis] & mask, found.leaf.octant.corner.at[axis]);
    }
}

void compare_tree(Reader& reader, Report& report, const TreeTruth& truth, const Octree& tree, LeafRule rule) {
    compare_measures(report, truth, measure(tree), digest(tree));
    std::uint32_t crc = 0;
    report.expect("status of write_stream", static_cast<int>(Status::ok),
                  static_cast<int>(write_stream(tree, header_of(rule), Sink{append_to_crc, &crc})));
    report.expect("CRC of the stream", truth.stream_crc, crc);
    compare_leaves(reader, report, truth.leaves, tree);
    for (std::uint8_t queries = reader.u8(); queries > 0; --queries) {
        const PointQuery query = read_query(reader);
        compare_query(report, query, leaf_at(tree, query.cell));
    }
}

void compare_leaves(Reader& reader, Report& report, const Octree& tree) {
    report.expect("depth", reader.u8(), tree.depth);
    compare_leaves(reader, report, reader.u32(), tree);
    report.expect("digest", reader.i64(), static_cast<std::int64_t>(digest(tree)));
}

StreamOutcome copied(const Octree& tree, LeafRule rule, StreamReader& copy, NodePool* pool) {
    copy.begin(pool);
    // A refused write shows in the reader's own status.
    static_cast<void>(write_stream(tree, header_of(rule), Sink{feed_reader, &copy}));
    return copy.finish();
}

Node* take_nodes(Arena& arena, std::uint32_t count) {
    return count > NodePool::max_capacity ? nullptr : arena.take_back<Node>(count);
}

} // namespace osem::cross
