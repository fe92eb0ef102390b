#include "osem/ray.hpp"
#include "osem/ray.hpp" // and once more: the guard
