#include "console/console.hpp"

#include <ostream>

#include "mesh/bad_input.hpp"

namespace osem::host {

void finish_printing(const Console& console) {
    console.out.flush();
    if (!console.out) throw BadInput("standard output: cannot be written");
}

} // namespace osem::host
