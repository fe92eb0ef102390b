#include "osem/stream_query.hpp"
#include "osem/stream_query.hpp" // and once more: the guard
