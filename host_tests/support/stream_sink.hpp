// A sink that keeps what it takes, watches what it is told, and may refuse.
#ifndef OSEM_SUPPORT_STREAM_SINK_HPP
#define OSEM_SUPPORT_STREAM_SINK_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "support/byte_stream.hpp"

namespace osem::tests {

struct TestSink {
    Bytes bytes;
    std::size_t writes = 0;
    std::size_t refuse_at = SIZE_MAX; ///< the number of writes that are taken
    bool refused = false;
    bool replaced = false;

    Sink sink() { return Sink{write, this}; }
    Sink replacing_sink() { return Sink{write, this, replace}; }
    static bool write(void* context, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<TestSink*>(context);
        EXPECT_FALSE(self.refused) << "a write after a refusal";
        EXPECT_FALSE(self.replaced) << "a write behind the last one";
        self.refused = self.writes == self.refuse_at;
        if (self.refused) return false;
        ++self.writes;
        self.bytes.insert(self.bytes.end(), bytes, bytes + count);
        return true;
    }
    static bool replace(void* context, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<TestSink*>(context);
        EXPECT_FALSE(self.refused) << "a write after a refusal";
        EXPECT_FALSE(self.replaced) << "replaced again";
        EXPECT_LE(count, self.bytes.size()) << "more than was written";
        self.refused = self.writes == self.refuse_at;
        if (self.refused || count > self.bytes.size()) return false;
        ++self.writes;
        self.replaced = true;
        std::copy_n(bytes, count, self.bytes.begin());
        return true;
    }
};

} // namespace osem::tests

#endif
