#include "osem/slice.hpp"
#include "osem/slice.hpp" // and once more: the guard
