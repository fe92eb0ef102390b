#include "osem/face_walk.hpp"
#include "osem/face_walk.hpp" // and once more: the guard
