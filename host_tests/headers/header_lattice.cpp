#include "osem/lattice.hpp"
#include "osem/lattice.hpp" // and once more: the guard
