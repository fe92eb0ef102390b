// Names that a C++ program may give to a namespace.
#ifndef OSEM_HOST_IDENTIFIER_HPP
#define OSEM_HOST_IDENTIFIER_HPP

#include <string>

namespace osem::host {

/// Why a name cannot be that of a namespace of a program; empty when it can. Names are made of ASCII letters,
/// digits and single underscores and begin with a letter; keywords up to C++20, osem, std and main are taken.
std::string identifier_fault(const std::string& name);

/// A valid name made from that of a file: its stem, with an underscore for what cannot stand in a name.
std::string identifier_of(const std::string& path);

} // namespace osem::host

#endif
