// The tool as a function, so that a test can run it without a process.
#ifndef OSEM_HOST_TOOL_HPP
#define OSEM_HOST_TOOL_HPP

#include <iosfwd>

namespace osem::host {

/// Exit codes, which other programs rely on.
constexpr int exit_ok = 0;
constexpr int exit_bad_usage = 1; ///< the command line is wrong; nothing was read or written
constexpr int exit_bad_input = 2; ///< a file cannot be read, used or written; no output file was left

/// Runs one command line. On failure exactly one line goes to `err`.
int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

} // namespace osem::host

#endif
