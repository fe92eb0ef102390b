#include "osem/csg.hpp"
#include "osem/csg.hpp" // and once more: the guard
