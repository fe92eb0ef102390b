// The canonical tree over cells of known colours, folded plainly, and all that a tree record says of it.
#ifndef OSEM_VECTORS_TREE_TRUTH_HPP
#define OSEM_VECTORS_TREE_TRUTH_HPP

#include <cstdint>
#include <vector>

#include "bytes.hpp"
#include "cell_grid.hpp"
#include "random.hpp"

namespace vectors {

/// Colours of the cells of one depth in a window, in Morton order; what is outside of the window is white.
struct ColouredCells {
    osem::Octant window;
    int depth;
    std::vector<osem::Colour> colours;
};

ColouredCells coloured(const oracle::CellGrid& grid, osem::LeafRule leaves, osem::WindingRule winding);

class TreeTruth {
  public:
    explicit TreeTruth(const ColouredCells& cells);

    /// Nodes below the top.
    std::uint32_t pool_nodes() const { return static_cast<std::uint32_t>(nodes_.size() - 1); }

    /// The tree record, with queries at random cells and at the root's ends.
    void put(Bytes& body, osem::LeafRule rule, Random& random) const;

  private:
    struct Leaf {
        int level;
        osem::Colour colour;
        std::uint64_t first; ///< the first of its cells of side 1, in Morton order
    };
    struct Masks {
        std::uint8_t may;
        std::uint8_t must;
    };

    osem::Colour fold(const osem::Octant& octant, const ColouredCells& cells);
    std::uint64_t leaves_of(osem::Colour colour) const;
    std::uint64_t volume_of(osem::Colour colour) const;
    std::uint64_t digest() const;
    std::vector<osem::Colour> preorder() const; ///< of all octants, grey ones too
    std::uint32_t stream_crc(osem::LeafRule rule) const;
    void put_query(Bytes& body, const osem::Point& cell) const;

    int depth_;
    std::size_t next_cell_ = 0;
    std::vector<Leaf> leaves_; ///< in Morton order
    std::vector<Masks> nodes_; ///< in preorder
};

} // namespace vectors

#endif
