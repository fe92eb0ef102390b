#include "support/target.hpp"

#include <cstdio>
#include <cstdlib>

namespace osem::fuzz {

namespace {

class AbortOnFailure : public testing::EmptyTestEventListener {
    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (!result.failed()) return;
        std::fprintf(stderr, "%s:%d: %s\n", result.file_name() != nullptr ? result.file_name() : "?",
                     result.line_number(), result.message());
        std::abort();
    }
};

void abort_on_failure() {
    static const bool listening = [] {
        testing::UnitTest::GetInstance()->listeners().Append(new AbortOnFailure); // the list owns it
        return true;
    }();
    static_cast<void>(listening);
}

} // namespace

} // namespace osem::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    osem::fuzz::abort_on_failure();
    osem::fuzz::Choices choices(bytes, count);
    osem::fuzz::run(choices);
    return 0;
}
