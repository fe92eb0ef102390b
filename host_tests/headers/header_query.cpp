#include "osem/query.hpp"
#include "osem/query.hpp" // and once more: the guard
