#include "osem/components.hpp"
#include "osem/components.hpp" // and once more: the guard
