#include "osem/classify.hpp"
#include "osem/classify.hpp" // and once more: the guard
