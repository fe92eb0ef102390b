// Nodes in a pool are never changed.
#include "osem/node_pool.hpp"

void change(osem::NodePool& pool) { pool.at(0).may = 1; }
