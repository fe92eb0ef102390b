#include "osem/stream_cursor.hpp"
#include "osem/stream_cursor.hpp" // and once more: the guard
