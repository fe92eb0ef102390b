// A source over bytes in memory that watches what it is asked for and may refuse.
#ifndef OSEM_SUPPORT_STREAM_SOURCE_HPP
#define OSEM_SUPPORT_STREAM_SOURCE_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "support/byte_stream.hpp"

namespace osem::tests {

inline Source source_of(const Bytes& bytes, bool checked = false) {
    Source source = memory_source(bytes.data(), bytes.size());
    source.checked = checked;
    return source;
}

/// What is known of a stream before it is read.
enum class Known { nothing, checked, indexed };
constexpr Known all_known[] = {Known::nothing, Known::checked, Known::indexed};

/// The index of a stream. Precondition: it is one.
inline Bytes index_of(const Bytes& bytes) {
    const std::size_t nodes = (bytes.size() - stream_header_size - stream_trailer_size) / 2;
    Bytes index(static_cast<std::size_t>(subtree_index_size(nodes)));
    EXPECT_EQ(check_stream(source_of(bytes), index.data(), index.size()).status, Status::ok);
    return index;
}

struct TestSource {
    explicit TestSource(const Bytes& all) : bytes(all) {}

    Source source() { return Source{read, this, bytes.size(), checked, index}; }

    const Bytes& bytes;
    std::size_t reads = 0;
    std::size_t fail_at = SIZE_MAX; ///< the number of reads that are answered
    std::uint64_t asked_at = 0;     ///< the offset last asked for
    bool checked = false;
    const std::uint8_t* index = nullptr;

  private:
    static bool read(void* context, std::uint64_t offset, std::uint8_t* to, std::size_t count) {
        auto& self = *static_cast<TestSource*>(context);
        self.asked_at = offset;
        if (self.reads == self.fail_at) return false;
        ++self.reads;
        if (count == 0 || offset + count > self.bytes.size()) {
            ADD_FAILURE() << count << " bytes asked for at " << offset << " of " << self.bytes.size();
            return false;
        }
        std::copy_n(self.bytes.begin() + static_cast<std::ptrdiff_t>(offset), count, to);
        return true;
    }
};

} // namespace osem::tests

#endif
