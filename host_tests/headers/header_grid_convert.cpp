#include "osem/grid_convert.hpp"
#include "osem/grid_convert.hpp" // and once more: the guard
