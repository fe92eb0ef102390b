#include "osem/tree_builder.hpp"
#include "osem/tree_builder.hpp" // and once more: the guard
