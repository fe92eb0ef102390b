#include "osem/bintree.hpp"
#include "osem/bintree.hpp" // and once more: the guard
