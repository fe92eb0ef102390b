// What `check` has to answer, found by plain means: maps of edges by the places of their ends, planes over
// integers of any length.
#ifndef OSEM_FUZZ_CHECK_MODEL_HPP
#define OSEM_FUZZ_CHECK_MODEL_HPP

#include "osem/solid.hpp"

namespace osem::fuzz {

/// Expects check to answer as its header says, with scratch of exactly the size stated and with less.
/// The outcome is that of the former.
CheckOutcome checked_as_expected(const Solid& solid);

} // namespace osem::fuzz

#endif
