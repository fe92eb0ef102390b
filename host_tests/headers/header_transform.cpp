#include "osem/transform.hpp"
#include "osem/transform.hpp" // and once more: the guard
