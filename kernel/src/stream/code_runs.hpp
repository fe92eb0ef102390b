// The codes of a tree in a pool: its octants in preorder.
#ifndef OSEM_STREAM_CODE_RUNS_HPP
#define OSEM_STREAM_CODE_RUNS_HPP

#include "osem/octree.hpp"
#include "stream/codes.hpp"

namespace osem {

/// Tells the codes of a tree in preorder, up to eight at a time: put(codes, count) takes them, the first one
/// lowest, and says whether to go on. Those behind a grey octant's code come with the next call. Returns what
/// the last call said.
template <class Put>
bool each_run_of_codes(const Octree& tree, Put put) {
    struct Frame {
        const Node* child; ///< the next grey one
        std::uint32_t codes;
        unsigned left; ///< codes
    };
    const auto entered = [&tree](const Node& node) {
        return Frame{&tree.pool->at(node.first()), codes_of_node(node), 8};
    };
    if (tree.top.is_uniform()) return put(static_cast<std::uint32_t>(tree.top.colour(0)), 1);
    if (!put(static_cast<std::uint32_t>(Colour::grey), 1)) return false;
    if (tree.top.grey() == 0) return put(codes_of_node(tree.top), 8);
    Frame frames[max_depth];
    int level = 0;
    frames[0] = entered(tree.top);
    while (level >= 0) {
        Frame& frame = frames[level];
        const auto greys = static_cast<unsigned>(grey_codes(frame.codes));
        if (greys == 0) {
            if (frame.left != 0 && !put(frame.codes, frame.left)) return false;
            --level;
            continue;
        }
        const unsigned bits = lowest_bit(greys) + 2;
        if (!put(frame.codes & ((1U << bits) - 1U), bits / 2)) return false;
        frame.codes >>= bits;
        frame.left -= bits / 2;
        const Node& child = *frame.child++;
        if (child.grey() != 0) {
            frames[++level] = entered(child);
        } else if (!put(codes_of_node(child), 8)) {
            return false;
        }
    }
    return true;
}

} // namespace osem

#endif
