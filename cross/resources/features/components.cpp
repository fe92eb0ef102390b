// Connected components of solid and void.
#include "features/roots.hpp"

#include "osem/components.hpp"

extern "C" {
auto components_roots = roots_of(&osem::ComponentLabelling::begin, &osem::ComponentLabelling::step,
                                 &osem::ComponentLabelling::finish, &osem::ComponentLabelling::fill,
                                 &osem::ComponentLabelling::component_of, &osem::measure);
}
