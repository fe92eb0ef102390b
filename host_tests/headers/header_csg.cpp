#include "osem/csg.hpp"
#include "osem/csg.hpp"
