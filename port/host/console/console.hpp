// Where the tool speaks.
#ifndef OSEM_HOST_CONSOLE_HPP
#define OSEM_HOST_CONSOLE_HPP

#include <iosfwd>

namespace osem::host {

/// The streams outlive it.
struct Console {
    std::ostream& out;
    std::ostream& err;
    bool terminal; ///< whether `err` is one, so that progress is worth showing
};

} // namespace osem::host

#endif
