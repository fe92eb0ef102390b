#include "osem/neighbour.hpp"
#include "osem/neighbour.hpp" // and once more: the guard
