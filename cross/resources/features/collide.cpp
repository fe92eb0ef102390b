// Collision of two trees.
#include "features/roots.hpp"

#include "osem/collide.hpp"

extern "C" {
auto collide_roots = roots_of(&osem::collide);
}
