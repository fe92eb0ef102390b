// The one way in which the mesh library refuses data.
#ifndef OSEM_HOST_MESH_BAD_INPUT_HPP
#define OSEM_HOST_MESH_BAD_INPUT_HPP

#include <stdexcept>

namespace osem::host {

/// Bad input: what() is one clear line for stderr (exit code 2).
class BadInput : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace osem::host

#endif
