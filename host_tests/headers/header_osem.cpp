#include "osem/osem.hpp"
#include "osem/osem.hpp" // and once more: the guard
