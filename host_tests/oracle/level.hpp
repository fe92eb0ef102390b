// How much to test: the environment variable OSEM_ORACLE_LEVEL is "fast" or "full"; without it an
// optimised build tests in full and a debug build fast.
#ifndef OSEM_ORACLE_LEVEL_HPP
#define OSEM_ORACLE_LEVEL_HPP

#include <cstdlib>
#include <string_view>

namespace oracle {

inline bool is_full() {
    if (const char* level = std::getenv("OSEM_ORACLE_LEVEL")) return std::string_view(level) == "full";
#ifdef NDEBUG
    return true;
#else
    return false;
#endif
}

} // namespace oracle

#endif
