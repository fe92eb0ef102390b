#include "osem/boolean.hpp"
#include "osem/boolean.hpp" // and once more: the guard
