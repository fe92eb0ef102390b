#include "support/byte_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace osem::tests {

std::uint32_t plain_crc(const std::uint8_t* bytes, std::size_t count) {
    std::uint32_t remainder = 0xffffffffU;
    for (std::size_t i = 0; i < 8 * count; ++i) {
        const std::uint32_t byte = bytes[i / 8];
        const std::uint32_t bit = (byte >> (i % 8)) & 1U;
        const bool divides = ((remainder ^ bit) & 1U) != 0;
        remainder = (remainder >> 1) ^ (divides ? 0xedb88320U : 0U); // the polynomial's bits in reverse
    }
    return ~remainder;
}

namespace {

void append_number(Bytes& bytes, std::uint64_t value, std::size_t width) {
    for (std::size_t i = 0; i < width; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
        value >>= 8;
    }
}

bool take(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& taken = *static_cast<Bytes*>(context);
    taken.insert(taken.end(), bytes, bytes + count);
    return true;
}

} // namespace

StreamModel::StreamModel(int tree_depth, const Masks& masks)
    : depth(static_cast<std::uint8_t>(tree_depth)), nodes(static_cast<std::uint32_t>(masks.size())) {
    for (const auto& [may, must] : masks) {
        payload.push_back(may);
        payload.push_back(must);
    }
}

Bytes StreamModel::bytes() const {
    Bytes all = magic;
    all.push_back(depth);
    all.push_back(leaf_rule);
    all.push_back(zero);
    for (const std::uint64_t word : frame) append_number(all, word, 8);
    append_number(all, nodes, 4);
    append_number(all, plain_crc(all.data(), all.size()), 4);
    all.insert(all.end(), payload.begin(), payload.end());
    append_number(all, plain_crc(payload.data(), payload.size()), 4);
    return all;
}

Bytes written(const Octree& tree, const StreamHeader& header) {
    Bytes bytes;
    EXPECT_EQ(write_stream(tree, header, Sink{take, &bytes}), Status::ok);
    return bytes;
}

StreamOutcome read_stream(StreamReader& reader, const Bytes& bytes, NodePool* pool, std::size_t chunk) {
    reader.begin(pool);
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t count = std::min(chunk, bytes.size() - at);
        reader.feed(bytes.data() + at, count);
        at += count;
    }
    return reader.finish();
}

} // namespace osem::tests
