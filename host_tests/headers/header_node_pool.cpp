#include "osem/node_pool.hpp"
#include "osem/node_pool.hpp" // and once more: the guard
