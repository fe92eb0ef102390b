#include "osem/preorder_path.hpp"
#include "osem/preorder_path.hpp" // and once more: the guard
