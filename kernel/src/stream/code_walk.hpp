// The codes of a tree in a pool: its octants in preorder.
#ifndef OSEM_STREAM_CODE_WALK_HPP
#define OSEM_STREAM_CODE_WALK_HPP

#include "osem/octree.hpp"

namespace osem {

/// Walks a tree's octants, grey ones and leaves, in preorder with O(depth) state.
class CodeWalk {
  public:
    explicit CodeWalk(const Octree& tree) : pool_(tree.pool), frames_{Frame{&tree.top, 0}} {
        colour_ = tree.top.is_uniform() ? tree.top.colour(0) : Colour::grey;
    }

    Colour colour() const { return colour_; }

    /// Goes on; false when there is none.
    bool next() {
        if (level_ < 0) {
            if (colour_ != Colour::grey) return false;
            level_ = 0;
        }
        while (frames_[level_].child == 8) {
            if (level_-- == 0) return false;
        }
        Frame& frame = frames_[level_];
        const unsigned child = frame.child++;
        colour_ = frame.node->colour(child);
        if (colour_ == Colour::grey) frames_[++level_] = Frame{&pool_->child(*frame.node, child), 0};
        return true;
    }

  private:
    struct Frame {
        const Node* node;
        std::uint8_t child; ///< the next child
    };
    const NodePool* pool_;
    Colour colour_;
    int level_ = -1; ///< of the innermost node entered
    Frame frames_[max_depth];
};

} // namespace osem

#endif
