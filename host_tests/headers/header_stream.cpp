#include "osem/stream.hpp"
#include "osem/stream.hpp" // and once more: the guard
