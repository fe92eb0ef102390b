#include "osem/fit.hpp"
#include "osem/fit.hpp" // and once more: the guard
