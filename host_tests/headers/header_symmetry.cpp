#include "osem/symmetry.hpp"
#include "osem/symmetry.hpp" // and once more: the guard
