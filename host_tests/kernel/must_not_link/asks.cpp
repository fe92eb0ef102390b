// A program that asks a tree; linked with a query.cpp of its own index width, or of the other one.
#include "osem/query.hpp"

int main() {
    const osem::NodePool pool = osem::NodePool::over(nullptr, 0);
    return osem::leaf_at(osem::Octree::uniform(pool, osem::Colour::black), osem::Point{{0, 0, 0}}).visited ==
                   1
               ? 0
               : 1;
}
