// A pool is not copied: its trees point to it.
#include "osem/node_pool.hpp"

osem::NodePool copied(const osem::NodePool& pool) { return osem::NodePool(pool); }
