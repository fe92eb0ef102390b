// What a target is: a function of bytes that ends the program when something is wrong. The same function is
// linked with libFuzzer, which looks for bytes, and with replay.cpp, which is given them.
#ifndef OSEM_FUZZ_TARGET_HPP
#define OSEM_FUZZ_TARGET_HPP

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "support/choices.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

namespace osem::fuzz {

/// What a target does with an input; defined by each. The first expectation that fails, here or in the
/// helpers of the tests, ends the program.
void run(Choices& choices);

} // namespace osem::fuzz

#endif
