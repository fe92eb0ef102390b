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

/// All that a command says on `out` has been said: throws, as BadInput, if it could not be. Asked before
/// files are put in their places.
void finish_printing(const Console& console);

} // namespace osem::host

#endif
