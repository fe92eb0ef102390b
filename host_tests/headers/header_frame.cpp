#include "osem/frame.hpp"
#include "osem/frame.hpp" // and once more: the guard
