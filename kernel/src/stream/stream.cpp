#include "osem/stream.hpp"

#include "osem/stream_builder.hpp"
#include "stream/code_runs.hpp"
#include "stream/codes.hpp"
#include "stream/header.hpp"

namespace osem {

Status write_stream(const Octree& tree, StreamHeader header, const Sink& sink) {
    header.depth = tree.depth;
    StreamBuilder builder;
    const auto put = [&builder](std::uint32_t codes, unsigned count) {
        return builder.put_canonical(codes, count);
    };
    builder.begin();
    if (sink.replace == nullptr) each_run_of_codes(tree, put);
    header.nodes = static_cast<std::uint32_t>(builder.nodes());
    builder.begin(header, sink);
    if (!builder.taken() || !each_run_of_codes(tree, put)) return Status::sink_refused;
    return builder.finish();
}

void StreamReader::begin(NodePool* pool) {
    builder_.begin(pool);
    header_ = StreamHeader{};
    position_ = 0;
    checksum_ = Checksum();
    crc_read_ = 0;
    status_ = Status::ok;
    has_header_ = false;
    trailer_left_ = stream_trailer_size;
}

Status StreamReader::feed(const std::uint8_t* bytes, std::size_t count) {
    while (count > 0 && status_ == Status::ok) {
        std::size_t taken = 1;
        if (has_header_ && !path_.whole()) {
            const std::uint64_t left = stream_size(header_.nodes) - stream_trailer_size - position_;
            taken = left < count ? static_cast<std::size_t>(left) : count;
            take_payload(bytes, taken);
        } else {
            take(*bytes);
            if (status_ == Status::ok) ++position_;
        }
        bytes += taken;
        count -= taken;
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

// Bytes of the payload, to the last code that is whole in them.
void StreamReader::take_payload(const std::uint8_t* bytes, std::size_t count) {
    checksum_.append(bytes, count);
    std::size_t taken = 0;
    std::uint32_t codes = 0;
    unsigned ready = 0;
    while (status_ == Status::ok && !path_.whole() && (ready != 0 || taken < count)) {
        for (; ready <= 12 && taken < count; ready += 4) {
            codes |= std::uint32_t{bytes[taken++]} << (2 * ready);
        }
        const unsigned used = take_codes(codes, ready);
        codes >>= 2 * used;
        ready -= used;
    }
    position_ += taken;
    if (status_ != Status::ok) { // in the byte of the last code that was used
        position_ -= ready / 4 + 1;
    } else if (path_.whole() && codes != 0) {
        --position_;
        fail(Status::stream_payload_damaged);
    }
}

// Takes the next octant, of some codes that are ready; with its eight children, if they are ready as well and
// leaves of more than one colour. Returns how many it took, the last one being that of a fault.
unsigned StreamReader::take_codes(std::uint32_t codes, unsigned ready) {
    const auto below = static_cast<std::uint16_t>(codes >> 2);
    const bool is_node = static_cast<Colour>(codes & 3U) == Colour::grey && ready > 8 &&
                         eight_leaves(grey_codes(below)) && !is_one_leaf(below);
    if (!is_node) {
        take_code(static_cast<Colour>(codes & 3U));
        return 1;
    }
    const int level = path_.level();
    const unsigned child = path_.child();
    Status status = path_.take(Colour::grey);
    if (status != Status::ok) {
        fail(status);
        return 1;
    }
    status = path_.take_leaves();
    if (status != Status::ok) {
        fail(status);
    } else if (level == 0) {
        builder_.leaves(may_of(below), must_of(below));
        builder_.close();
    } else {
        builder_.eight_leaves(child, may_of(below), must_of(below));
        close_to(level);
    }
    return 9;
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
    close_to(level);
}

// Closes what the path has left since it was at a level.
void StreamReader::close_to(int level) {
    for (; level > path_.level(); --level) builder_.close();
}

void StreamReader::take_trailer_byte(std::uint8_t byte) {
    crc_read_ |= static_cast<std::uint32_t>(byte) << (8 * (stream_trailer_size - trailer_left_));
    if (--trailer_left_ == 0 && crc_read_ != checksum_.value()) {
        position_ -= stream_trailer_size - 1;
        fail(Status::stream_payload_damaged);
    }
}

} // namespace osem
