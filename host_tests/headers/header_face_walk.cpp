#include "osem/face_walk.hpp"
#include "osem/face_walk.hpp"
