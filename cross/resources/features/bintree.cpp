// Conversion by a bintree and labelling.
#include "features/roots.hpp"

#include "osem/bintree.hpp"

extern "C" {
auto bintree_roots = roots_of(&osem::Labelling::begin, &osem::Labelling::step, &osem::Labelling::finish);
}
