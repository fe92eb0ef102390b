#include "memory.hpp"

namespace osem::cross {

namespace {

StaticNodePool<pool_capacity> nodes;
std::uint32_t faces[32];

} // namespace

NodePool& pool = nodes;
Conversion conversion;
alignas(8) unsigned char workspace[workspace_size];
Edge edges[most_corners];

TreeOutcome converted(const Solid& solid, const ConvertOptions& options, NodePool* into) {
    const CheckOutcome outcome = check(solid, edges, most_corners);
    if (outcome.status != Status::ok) {
        return {outcome.status, 0, 0, Octree::uniform(pool, Colour::white)};
    }
    return convert(conversion, outcome.solid, options, faces, sizeof faces / sizeof *faces, into);
}

} // namespace osem::cross
