#include "osem/config.hpp"
#include "osem/config.hpp" // and once more: the guard
