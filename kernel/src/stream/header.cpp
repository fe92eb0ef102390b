#include "stream/header.hpp"

#include "stream/crc.hpp"

namespace osem {

namespace {

constexpr std::uint8_t version = 2; // version 1 held the masks of nodes instead of the colours of octants
constexpr std::uint8_t magic[5] = {'O', 'S', 'E', 'M', version};
constexpr std::size_t depth_at = 5;
constexpr std::size_t leaf_rule_at = 6;
constexpr std::size_t zero_at = 7;
constexpr std::size_t frame_at = 8;
constexpr std::size_t nodes_at = 40;
constexpr std::size_t crc_at = 44;

} // namespace

void encode_header(const StreamHeader& header, std::uint8_t* bytes) {
    OSEM_ASSERT(header.leaf_rule <= 1);
    for (std::size_t i = 0; i < sizeof magic; ++i) bytes[i] = magic[i];
    bytes[depth_at] = header.depth;
    bytes[leaf_rule_at] = header.leaf_rule;
    bytes[zero_at] = 0;
    for (std::size_t i = 0; i < 4; ++i) put_number(bytes + frame_at + 8 * i, header.frame[i]);
    put_number(bytes + nodes_at, header.nodes);
    put_number(bytes + crc_at, crc_append(0, bytes, crc_at));
}

bool begins_header(std::size_t at, std::uint8_t byte) { return at >= sizeof magic || byte == magic[at]; }

HeaderOutcome decode_header(const std::uint8_t* bytes) {
    HeaderOutcome outcome = {Status::stream_header_damaged, crc_at, {}};
    if (get_number<std::uint32_t>(bytes + crc_at) != crc_append(0, bytes, crc_at)) return outcome;
    StreamHeader& header = outcome.header;
    header.depth = bytes[depth_at];
    header.leaf_rule = bytes[leaf_rule_at];
    for (std::size_t i = 0; i < 4; ++i) {
        header.frame[i] = get_number<std::uint64_t>(bytes + frame_at + 8 * i);
    }
    header.nodes = get_number<std::uint32_t>(bytes + nodes_at);
    if (header.depth < 1 || header.depth > max_depth) {
        outcome.status = Status::depth_out_of_range;
        outcome.offset = depth_at;
    } else if (header.leaf_rule > 1 || bytes[zero_at] != 0) {
        outcome.offset = header.leaf_rule > 1 ? leaf_rule_at : zero_at;
    } else {
        outcome.status = Status::ok;
        outcome.offset = stream_header_size;
    }
    return outcome;
}

} // namespace osem
