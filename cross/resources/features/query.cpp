// Point and box queries on a tree that lies in flash.
#include "features/roots.hpp"

#include "osem/query.hpp"

extern "C" {
auto query_roots = roots_of(&osem::leaf_at, &osem::colours_in);
}
