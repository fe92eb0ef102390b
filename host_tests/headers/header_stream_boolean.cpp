#include "osem/stream_boolean.hpp"
#include "osem/stream_boolean.hpp" // and once more: the guard
