#include "osem/collide.hpp"
#include "osem/collide.hpp" // and once more: the guard
