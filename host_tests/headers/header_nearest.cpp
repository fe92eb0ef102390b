#include "osem/nearest.hpp"
#include "osem/nearest.hpp" // and once more: the guard
