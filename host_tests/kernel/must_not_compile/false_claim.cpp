// With contract checks a false claim in a constant expression is seen by the compiler.
#define OSEM_ASSERT(condition) ((condition) ? static_cast<void>(0) : __builtin_trap())
#include "osem/bounded.hpp"

constexpr auto false_claim = osem::Bounded<0, 5>::claim(6);
