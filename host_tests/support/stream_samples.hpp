// Trees of plain recursion, many of them random, and their streams.
#ifndef OSEM_SUPPORT_STREAM_SAMPLES_HPP
#define OSEM_SUPPORT_STREAM_SAMPLES_HPP

#include <cstdint>
#include <random>
#include <vector>

#include "osem/boolean.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

/// An octant: a leaf, or grey with eight children. Never eight equal leaves.
struct Part {
    Colour colour = Colour::white;
    std::vector<Part> children;
};

/// One that is grey, mostly: each octant below it is with a chance of `grey` in 16. Thin trees reach deep,
/// dense ones are full of leaf groups.
Part grey_part(int levels, unsigned grey, const std::vector<Colour>& palette, std::mt19937& random);

/// An octant of `levels` levels with at least one grey octant at each but the last, and at the two above that
/// any number of grey children in any places.
Part bushy_part(int levels, const std::vector<Colour>& palette, std::mt19937& random);

Part combined(Operator op, const Part& a, const Part& b);

/// In preorder.
std::vector<Colour> colours_of(const Part& part);

struct Sample {
    Part part;
    int depth;

    Bytes bytes() const { return StreamModel(depth, colours_of(part)).bytes(); }
};

/// Of every depth and of two or three colours; dense ones are flat.
Sample sample_of(std::uint32_t seed);

/// A stream that lies in memory, or one that must be read.
struct Place {
    Place(const Bytes& bytes, Known known, bool read);
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    Bytes exact; ///< no memory behind its last byte, so that a sanitizer sees what is read there
    Bytes index;
    TestSource reader;
    Source source;
};

} // namespace osem::tests

#endif
