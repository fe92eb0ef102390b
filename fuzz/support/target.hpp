// What a target is: a function of bytes that ends the program when something is wrong. The same function is
// linked with libFuzzer, which looks for bytes, and with replay.cpp, which is given them.
#ifndef OSEM_FUZZ_TARGET_HPP
#define OSEM_FUZZ_TARGET_HPP

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

namespace osem::fuzz {

/// Makes the first expectation that fails, here or in the helpers of the tests, end the program.
/// Cost: nothing after the first call.
void abort_on_failure();

} // namespace osem::fuzz

#endif
