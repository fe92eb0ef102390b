#include "osem/bounded.hpp"
#include "osem/bounded.hpp" // and once more: the guard
