#include "osem/cluster_walk.hpp"
#include "osem/cluster_walk.hpp" // and once more: the guard
