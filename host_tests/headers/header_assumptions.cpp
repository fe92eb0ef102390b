#include "osem/assumptions.hpp"
#include "osem/assumptions.hpp" // and once more: the guard
