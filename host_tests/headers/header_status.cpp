#include "osem/status.hpp"
#include "osem/status.hpp" // and once more: the guard
