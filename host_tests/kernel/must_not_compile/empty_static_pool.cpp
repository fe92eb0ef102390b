// A static pool has room for a node.
#include "osem/node_pool.hpp"

auto capacity() { return osem::StaticNodePool<0>().capacity(); }
