// Booleans from stream to stream.
#include "features/roots.hpp"

#include "osem/stream_boolean.hpp"

namespace {

using Combine = osem::StreamCombinationOutcome (*)(osem::StreamCombination&, osem::Operator,
                                                   const osem::Source&, const osem::Source&,
                                                   const osem::Sink&);
using Complement = osem::StreamCombinationOutcome (*)(osem::StreamCombination&, const osem::Source&,
                                                      const osem::Sink&);

} // namespace

extern "C" {
auto stream_boolean_roots =
    roots_of(static_cast<Combine>(&osem::combine), static_cast<Complement>(&osem::complement));
}
