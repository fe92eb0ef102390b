#include "osem/stream.hpp"

#include "stream/crc.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

constexpr std::uint8_t version = 1;
constexpr std::uint8_t magic[5] = {'O', 'S', 'E', 'M', version};
constexpr std::size_t depth_at = 5;
constexpr std::size_t leaf_rule_at = 6;
constexpr std::size_t zero_at = 7;
constexpr std::size_t frame_at = 8;
constexpr std::size_t nodes_at = 40;
constexpr std::size_t header_crc_at = 44;

template <class Integer>
void put(std::uint8_t* bytes, Integer value) {
    for (std::size_t i = 0; i < sizeof(Integer); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

template <class Integer>
Integer get(const std::uint8_t* bytes) {
    Integer value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) value |= static_cast<Integer>(bytes[i]) << (8 * i);
    return value;
}

void encode(const StreamHeader& header, std::uint8_t* bytes) {
    OSEM_ASSERT(header.leaf_rule <= 1);
    for (std::size_t i = 0; i < sizeof magic; ++i) bytes[i] = magic[i];
    bytes[depth_at] = header.depth;
    bytes[leaf_rule_at] = header.leaf_rule;
    bytes[zero_at] = 0;
    for (std::size_t i = 0; i < 4; ++i) put(bytes + frame_at + 8 * i, header.frame[i]);
    put(bytes + nodes_at, header.nodes);
    put(bytes + header_crc_at, crc_append(0, bytes, header_crc_at));
}

std::uint32_t count_nodes(const Octree& tree) {
    std::uint32_t nodes = 0;
    for (NodeWalk walk(tree); !walk.done(); walk.next()) ++nodes;
    return nodes;
}

// The payload goes to the sink in small pieces, so that a sink may be a slow one.
class Writer {
  public:
    explicit Writer(const Sink& sink) : sink_(sink) {}
    bool put_node(const Node& node) {
        buffer_[filled_++] = node.may;
        buffer_[filled_++] = node.must;
        return filled_ < sizeof buffer_ || flush();
    }
    bool flush() {
        crc_ = crc_append(crc_, buffer_, filled_);
        const std::size_t count = filled_;
        filled_ = 0;
        return count == 0 || sink_.write(sink_.context, buffer_, count);
    }
    bool put_trailer() {
        put(buffer_, crc_);
        return sink_.write(sink_.context, buffer_, stream_trailer_size);
    }

  private:
    Sink sink_;
    std::uint32_t crc_ = 0;
    std::size_t filled_ = 0;
    std::uint8_t buffer_[64] = {};
};

} // namespace

Status write_stream(const Octree& tree, StreamHeader header, const Sink& sink) {
    header.depth = tree.depth;
    header.nodes = count_nodes(tree);
    std::uint8_t bytes[stream_header_size];
    encode(header, bytes);
    if (!sink.write(sink.context, bytes, sizeof bytes)) return Status::sink_refused;
    Writer writer(sink);
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        if (!writer.put_node(walk.node())) return Status::sink_refused;
    }
    return writer.flush() && writer.put_trailer() ? Status::ok : Status::sink_refused;
}

void StreamReader::begin(NodePool* pool) {
    builder_.begin(pool);
    header_ = StreamHeader{};
    position_ = 0;
    crc_ = 0;
    crc_read_ = 0;
    status_ = Status::ok;
    level_ = -1;
    trailer_left_ = stream_trailer_size;
}

Status StreamReader::feed(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count && status_ == Status::ok; ++i) {
        take(bytes[i]);
        if (status_ == Status::ok) ++position_;
    }
    return status_;
}

StreamOutcome StreamReader::finish() {
    if (status_ == Status::ok && trailer_left_ != 0) fail(Status::stream_truncated);
    StreamOutcome outcome = {builder_.finish(header_.depth), position_};
    if (status_ != Status::ok) {
        outcome.built.status = status_;
        outcome.built.nodes_missing = 0;
    }
    return outcome;
}

void StreamReader::fail(Status status) {
    status_ = status;
    builder_.abandon();
}

void StreamReader::take(std::uint8_t byte) {
    if (position_ < stream_header_size) {
        take_header_byte(byte);
    } else if (!builder_.finished()) {
        crc_ = crc_append(crc_, byte);
        if (position_ % 2 == 0) {
            may_ = byte;
        } else {
            take_node(may_, byte);
        }
    } else if (trailer_left_ != 0) {
        take_trailer_byte(byte);
    } else {
        fail(Status::stream_trailing_bytes);
    }
}

void StreamReader::take_header_byte(std::uint8_t byte) {
    bytes_[position_] = byte;
    if (position_ < sizeof magic && byte != magic[position_]) fail(Status::stream_not_osem);
    if (position_ == stream_header_size - 1) take_header();
}

void StreamReader::take_header() {
    if (get<std::uint32_t>(bytes_ + header_crc_at) != crc_append(0, bytes_, header_crc_at)) {
        position_ = header_crc_at;
        return fail(Status::stream_header_damaged);
    }
    StreamHeader header = {bytes_[depth_at], bytes_[leaf_rule_at], {}, get<std::uint32_t>(bytes_ + nodes_at)};
    for (std::size_t i = 0; i < 4; ++i) header.frame[i] = get<std::uint64_t>(bytes_ + frame_at + 8 * i);
    if (header.depth < 1 || header.depth > max_depth) {
        position_ = depth_at;
        fail(Status::depth_out_of_range);
    } else if (header.leaf_rule > 1 || bytes_[zero_at] != 0) {
        position_ = header.leaf_rule > 1 ? leaf_rule_at : zero_at;
        fail(Status::stream_header_damaged);
    } else if (header.nodes == 0) {
        position_ = nodes_at;
        fail(Status::stream_count_mismatch);
    } else {
        header_ = header;
        nodes_left_ = header.nodes;
    }
}

void StreamReader::take_node(std::uint8_t may, std::uint8_t must) {
    const Node node = Node::of(may, must, 0);
    const int level = level_ + 1; // a grey child of the last node that has any left
    if (nodes_left_ == 0) return fail(Status::stream_count_mismatch);
    if (level > 0 && node.is_uniform()) return fail(Status::stream_not_canonical);
    if (node.grey() != 0 && level + 1 >= header_.depth) return fail(Status::stream_too_deep);
    --nodes_left_;
    if (level > 0) {
        builder_.open(lowest(left_[level_]));
        left_[level_] = without_lowest(left_[level_]);
    }
    level_ = level;
    left_[level_] = node.grey();
    builder_.leaves(
        may, static_cast<std::uint8_t>(must & ~node.grey())); // grey children are grafted as they close
    while (level_ >= 0 && left_[level_] == 0) {
        builder_.close();
        --level_;
    }
    if (builder_.finished() && nodes_left_ != 0) fail(Status::stream_count_mismatch);
}

void StreamReader::take_trailer_byte(std::uint8_t byte) {
    crc_read_ |= static_cast<std::uint32_t>(byte) << (8 * (stream_trailer_size - trailer_left_));
    if (--trailer_left_ == 0 && crc_read_ != crc_) {
        position_ -= stream_trailer_size - 1;
        fail(Status::stream_payload_damaged);
    }
}

} // namespace osem
