#include "osem/octree.hpp"
#include "osem/octree.hpp" // and once more: the guard
