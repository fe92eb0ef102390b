#include "osem/convert.hpp"
#include "osem/convert.hpp" // and once more: the guard
