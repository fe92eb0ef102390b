// Streams built by hand, byte by byte, and ways to write and read them.
#ifndef OSEM_SUPPORT_BYTE_STREAM_HPP
#define OSEM_SUPPORT_BYTE_STREAM_HPP

#include <cstdint>
#include <vector>

#include "osem/stream.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

using Bytes = std::vector<std::uint8_t>;

/// CRC-32 a bit at a time, as the standard defines it.
std::uint32_t plain_crc(const std::uint8_t* bytes, std::size_t count);

/// The colours of a tree's octants in preorder, from its nodes in preorder. Nodes too many are put behind,
/// and where there are too few the colours end.
std::vector<Colour> preorder_colours(const Masks& masks);

/// Four colours a byte, the first one lowest.
Bytes packed(const std::vector<Colour>& colours);

/// The fields of a stream; their bytes are laid out as the header documents, with right checksums.
struct StreamModel {
    Bytes magic{'O', 'S', 'E', 'M', 2};
    std::uint8_t depth = 1;
    std::uint8_t leaf_rule = 0;
    std::uint8_t zero = 0;
    std::uint64_t frame[4] = {0, 0, 0, 0};
    std::uint32_t nodes = 0;
    Bytes payload;

    StreamModel(int tree_depth, const Masks& masks);
    /// A payload of its own; its node count is the number of grey octants.
    StreamModel(int tree_depth, const std::vector<Colour>& colours);
    Bytes bytes() const;
};

/// What write_stream writes.
Bytes written(const Octree& tree, const StreamHeader& header);

/// The stream of a grid's tree, without the kernel.
inline Bytes stream_of(const DenseGrid& grid) {
    return StreamModel(grid.depth(), preorder_masks(grid)).bytes();
}

/// Reads whole streams in chunks. `reader` is the working memory.
StreamOutcome read_stream(StreamReader& reader, const Bytes& bytes, NodePool* pool,
                          std::size_t chunk = SIZE_MAX);

} // namespace osem::tests

#endif
