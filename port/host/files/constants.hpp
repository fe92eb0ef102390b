// Trees and solids as constants of a C++ header, for programs that keep them in flash.
#ifndef OSEM_HOST_CONSTANTS_HPP
#define OSEM_HOST_CONSTANTS_HPP

#include <ostream>
#include <string>

#include "files/tree_file.hpp"
#include "mesh/quantize.hpp"
#include "osem/convert.hpp"
#include "osem/octree.hpp"

namespace osem::host {

/// What a header is called and where it came from.
struct ConstantsName {
    std::string space;  ///< the namespace that holds the constants; see identifier_fault
    std::string source; ///< name of the file they were read from, without its folder
};

/// Writes `nodes` (unless the top is all), `pool` and `tree`. The pool must hold nothing else than the tree.
/// The text depends on the arguments alone.
void write_constants(std::ostream& out, const ConstantsName& name, const Octree& tree,
                     const TreeFacts& facts);

/// Writes `vertices`, `corners`, `ring_starts` and `face_rings` (unless all faces are triangles), `solid` and
/// `winding`. The solid must have been checked.
void write_constants(std::ostream& out, const ConstantsName& name, const IntegerSolid& solid,
                     WindingRule winding);

} // namespace osem::host

#endif
