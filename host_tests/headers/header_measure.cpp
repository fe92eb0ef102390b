#include "osem/measure.hpp"
#include "osem/measure.hpp" // and once more: the guard
