// Nor is it assigned to.
#include "osem/node_pool.hpp"

void assign(osem::NodePool& to, const osem::NodePool& from) { to = from; }
