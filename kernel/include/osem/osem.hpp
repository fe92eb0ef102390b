// The whole kernel in one include.
#ifndef OSEM_OSEM_HPP
#define OSEM_OSEM_HPP

#include "osem/bintree.hpp"
#include "osem/boolean.hpp"
#include "osem/boundary.hpp"
#include "osem/bounded.hpp"
#include "osem/classify.hpp"
#include "osem/cluster_walk.hpp"
#include "osem/collide.hpp"
#include "osem/components.hpp"
#include "osem/config.hpp"
#include "osem/convert.hpp"
#include "osem/fit.hpp"
#include "osem/frame.hpp"
#include "osem/lattice.hpp"
#include "osem/measure.hpp"
#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"
#include "osem/node_pool.hpp"
#include "osem/octree.hpp"
#include "osem/preorder_path.hpp"
#include "osem/query.hpp"
#include "osem/ray.hpp"
#include "osem/slice.hpp"
#include "osem/solid.hpp"
#include "osem/status.hpp"
#include "osem/stream.hpp"
#include "osem/stream_cursor.hpp"
#include "osem/tree_builder.hpp"

#endif
