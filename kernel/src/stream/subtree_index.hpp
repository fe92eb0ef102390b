// Where the subtrees of a stream can end: so one is passed without reading what it holds.
#ifndef OSEM_STREAM_SUBTREE_INDEX_HPP
#define OSEM_STREAM_SUBTREE_INDEX_HPP

#include <cstddef>
#include <cstdint>

#include "osem/stream.hpp"

namespace osem {

/// What an index says of a block of codes. Octants to come are those whose parents have gone by: the root
/// octant before all codes; behind a leaf's code one less, behind a grey one seven more. A subtree ends where
/// they are, for the first time, as many as they were before it, less one. They are never more than
/// 8 + 7 (max_depth - 1) = 141.
struct IndexedBlock {
    static constexpr unsigned bytes = 64; ///< of the payload
    static constexpr unsigned codes = 4 * bytes;

    std::uint8_t to_come; ///< before the first code
    std::uint8_t least;   ///< of those to come before and behind each code of the block
};

/// The number of a block in an index.
inline IndexedBlock indexed_block(const std::uint8_t* index, std::uint32_t number) {
    const std::size_t at = std::size_t{2} * number;
    return {index[at], index[at + 1]};
}

/// A source that is read from the beginning to the end, whose blocks are indexed by the way. It is the
/// context of what it reads for: source() must not outlive it.
class IndexedReading {
  public:
    IndexedReading(const Source& source, std::uint8_t* index) : source_(source), next_(index) {}
    Source source() { return Source{read, this, source_.size}; }

  private:
    static bool read(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count);
    void add_block(const std::uint8_t* bytes, std::size_t count);

    Source source_;
    std::uint8_t* next_;
    std::uint32_t to_come_ = 1;
};

} // namespace osem

#endif
