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

struct TestSource {
    explicit TestSource(const Bytes& all) : bytes(all) {}

    Source source() { return Source{read, this, bytes.size(), checked}; }

    const Bytes& bytes;
    std::size_t reads = 0;
    std::size_t fail_at = SIZE_MAX; ///< the number of reads that are answered
    std::uint64_t asked_at = 0;     ///< the offset last asked for
    bool checked = false;

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
