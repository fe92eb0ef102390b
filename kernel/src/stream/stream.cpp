#include "osem/stream.hpp"

#include "osem/stream_builder.hpp"
#include "stream/code_walk.hpp"
#include "stream/crc.hpp"
#include "stream/header.hpp"

namespace osem {

Status write_stream(const Octree& tree, StreamHeader header, const Sink& sink) {
    header.depth = tree.depth;
    header.nodes = 0;
    if (!tree.top.is_uniform()) {
        for (NodeWalk walk(tree); !walk.done(); walk.next()) ++header.nodes;
    }
    StreamBuilder builder;
    builder.begin(header, sink);
    CodeWalk walk(tree);
    do {
        if (!builder.taken()) return Status::sink_refused;
        walk.colour() == Colour::grey ? builder.open() : builder.leaf(walk.colour());
    } while (walk.next());
    return builder.finish();
}

void StreamReader::begin(NodePool* pool) {
    builder_.begin(pool);
    header_ = StreamHeader{};
    position_ = 0;
    crc_ = 0;
    crc_read_ = 0;
    status_ = Status::ok;
    has_header_ = false;
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
    if (status_ != Status::ok) outcome.built.status = status_;
    return outcome;
}

void StreamReader::fail(Status status) {
    status_ = status;
    builder_.abandon();
}

void StreamReader::take(std::uint8_t byte) {
    if (position_ < stream_header_size) {
        take_header_byte(byte);
    } else if (!path_.whole()) {
        crc_ = crc_append(crc_, byte);
        take_codes(byte);
    } else if (trailer_left_ != 0) {
        take_trailer_byte(byte);
    } else {
        fail(Status::stream_trailing_bytes);
    }
}

void StreamReader::take_header_byte(std::uint8_t byte) {
    const auto at = static_cast<std::size_t>(position_);
    bytes_[at] = byte;
    if (!begins_header(at, byte)) return fail(Status::stream_not_osem);
    if (at < stream_header_size - 1) return;
    const HeaderOutcome outcome = decode_header(bytes_);
    if (outcome.status != Status::ok) {
        position_ = outcome.offset;
        return fail(outcome.status);
    }
    header_ = outcome.header;
    has_header_ = true;
    path_.begin(header_.depth, header_.nodes);
}

void StreamReader::take_codes(std::uint8_t byte) {
    unsigned codes = byte;
    for (unsigned left = 4; left > 0 && !path_.whole() && status_ == Status::ok; --left, codes >>= 2) {
        take_code(static_cast<Colour>(codes & 3U));
    }
    if (status_ == Status::ok && codes != 0) fail(Status::stream_payload_damaged);
}

void StreamReader::take_code(Colour code) {
    const int level = path_.level();
    const unsigned child = path_.child();
    const Status status = path_.take(code);
    if (status != Status::ok) return fail(status);
    if (code == Colour::grey) {
        if (level > 0) builder_.open(child);
        return;
    }
    if (level == 0) {
        const Node node = Node::uniform(code);
        builder_.leaves(node.may, node.must);
        return builder_.close();
    }
    builder_.leaf(child, code);
    for (int closed = level; closed > path_.level(); --closed) builder_.close();
}

void StreamReader::take_trailer_byte(std::uint8_t byte) {
    crc_read_ |= static_cast<std::uint32_t>(byte) << (8 * (stream_trailer_size - trailer_left_));
    if (--trailer_left_ == 0 && crc_read_ != crc_) {
        position_ -= stream_trailer_size - 1;
        fail(Status::stream_payload_damaged);
    }
}

} // namespace osem
