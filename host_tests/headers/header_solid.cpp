#include "osem/solid.hpp"
#include "osem/solid.hpp" // and once more: the guard
