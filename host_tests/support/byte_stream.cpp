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

namespace {

// The colours of a node's children, each grey one followed by those below it.
void append_children(std::vector<Colour>& colours, const Masks& masks, std::size_t& next) {
    if (next == masks.size()) return;
    const auto [may, must] = masks[next++];
    for (unsigned k = 0; k < 8; ++k) {
        const unsigned code = ((may >> k) & 1U) + 2 * ((must >> k) & 1U);
        colours.push_back(static_cast<Colour>(code));
        if (colours.back() == Colour::grey) {
            if (next == masks.size()) return;
            append_children(colours, masks, next);
        }
    }
}

} // namespace

std::vector<Colour> preorder_colours(const Masks& masks) {
    const auto [may, must] = masks.at(0);
    if (masks.size() == 1 && (may == 0 || may == 0xff) && (must == 0 || must == 0xff) && may >= must) {
        return {may == 0 ? Colour::white : must == 0 ? Colour::boundary : Colour::black};
    }
    std::vector<Colour> colours{Colour::grey};
    for (std::size_t next = 0; next < masks.size();) append_children(colours, masks, next);
    return colours;
}

Bytes packed(const std::vector<Colour>& colours) {
    Bytes bytes((colours.size() + 3) / 4, 0);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const unsigned code = static_cast<unsigned>(colours[i]) << (2 * (i % 4));
        bytes[i / 4] = static_cast<std::uint8_t>(bytes[i / 4] | code);
    }
    return bytes;
}

StreamModel::StreamModel(int tree_depth, const Masks& masks)
    : StreamModel(tree_depth, preorder_colours(masks)) {}

StreamModel::StreamModel(int tree_depth, const std::vector<Colour>& colours)
    : depth(static_cast<std::uint8_t>(tree_depth)),
      nodes(static_cast<std::uint32_t>(std::count(colours.begin(), colours.end(), Colour::grey))),
      payload(packed(colours)) {}

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
