#include "osem/stream_builder.hpp"
#include "osem/stream_builder.hpp" // and once more: the guard
