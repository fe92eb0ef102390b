#include "osem/boundary.hpp"
#include "osem/boundary.hpp" // and once more: the guard
