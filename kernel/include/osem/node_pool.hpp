// Nodes and the pool they live in.
#ifndef OSEM_NODE_POOL_HPP
#define OSEM_NODE_POOL_HPP

#include <cstdint>

#include "osem/assumptions.hpp"
#include "osem/config.hpp"
#include "osem/status.hpp"

namespace osem {

#if OSEM_NODE_INDEX_BITS == 32
using NodeIndex = std::uint32_t;
#elif OSEM_NODE_INDEX_BITS == 16
using NodeIndex = std::uint16_t;
#else
#error "OSEM_NODE_INDEX_BITS is 16 or 32"
#endif

/// The colour of an octant. White is empty, black is solid throughout, boundary is a leaf that may hold
/// both, grey has children. As a number: bit 0 is `may`, bit 1 is `must`.
enum class Colour : std::uint8_t { white = 0, boundary = 1, grey = 2, black = 3 };

/// A node describes its eight children. Bit k of `may` says that child k can hold solid, bit k of `must`
/// that it is solid throughout; a bit in `must` alone marks a grey child, whose node stands in the pool. The
/// grey children of a node stand together in ascending order of k; `first` is the index of the first.
/// Nodes are 6 bytes (4 with 16-bit indices) and need an alignment of 2.
struct OSEM_OF_INDEX_WIDTH Node {
    std::uint8_t may;
    std::uint8_t must;
    std::uint16_t first_low; ///< the index, split so that a node needs no padding
#if OSEM_NODE_INDEX_BITS == 32
    std::uint16_t first_high;
#endif

    static constexpr Node of(std::uint8_t may, std::uint8_t must, NodeIndex first) {
#if OSEM_NODE_INDEX_BITS == 32
        return Node{may, must, static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(first >> 16)};
#else
        return Node{may, must, first};
#endif
    }

    /// The node of an octant of one leaf colour. Precondition: colour is not grey.
    static constexpr Node uniform(Colour colour) {
        return of(colour == Colour::white ? 0x00 : 0xff, colour == Colour::black ? 0xff : 0x00, 0);
    }

    /// The mask of the grey children.
    constexpr std::uint8_t grey() const { return static_cast<std::uint8_t>(~may & must); }

    /// Index of the first grey child; 0 when there is none.
    constexpr NodeIndex first() const {
#if OSEM_NODE_INDEX_BITS == 32
        return static_cast<NodeIndex>(first_low) | (static_cast<NodeIndex>(first_high) << 16);
#else
        return first_low;
#endif
    }

    /// Colour of child k in [0, 8).
    constexpr Colour colour(unsigned k) const {
        return static_cast<Colour>(((may >> k) & 1U) | (((must >> k) & 1U) << 1));
    }

    /// Whether all eight children are one leaf colour, and which. Only the top node of a tree may be so.
    constexpr bool is_uniform() const {
        // White or black, whose masks one more leaves without a bit between; or boundary.
        return may == must ? ((may + 1U) & 0xfeU) == 0 : may == 0xff && must == 0x00;
    }

    friend constexpr bool operator==(const Node& a, const Node& b) {
        return a.may == b.may && a.must == b.must && a.first() == b.first();
    }
    friend constexpr bool operator!=(const Node& a, const Node& b) { return !(a == b); }
};

static_assert(sizeof(Node) == (OSEM_NODE_INDEX_BITS == 32 ? 6 : 4), "nodes are packed");

/// Number of bits set in a mask of children: the first product has the mask four times, nine places apart, so
/// that each fourth place from 3 on holds another bit of it; the second one adds these up.
constexpr unsigned count_bits(std::uint8_t mask) {
    return (((std::uint32_t{mask} * 0x08040201U) >> 3 & 0x11111111U) * 0x11111111U) >> 28;
}

/// A pool of nodes over memory of the caller. It only grows, so a node once written is never changed:
/// every index below a mark may be read, from an interrupt or another core, while nodes above it are being
/// written, provided that the reader got its tree after the tree was finished (with whatever barrier the
/// part needs to publish a pointer). Compaction and roll-back below a live tree are the two exceptions.
///
/// A read-only pool stands over constant nodes, in flash for example. It is full for good: its trees are read
/// like any others, nothing is ever written through it. Pool and trees are then constants themselves:
///
///     constexpr osem::Node nodes[] = {...};
///     constexpr osem::NodePool pool = osem::NodePool::over(nodes, 3);
///     constexpr osem::Octree zone = {&pool, osem::Node::of(0x0f, 0x10, 2), 4};
class OSEM_OF_INDEX_WIDTH NodePool {
  public:
    /// The greatest usable capacity; a larger one is clipped. One index is kept free as a sentinel.
    static constexpr std::uint32_t max_capacity = static_cast<NodeIndex>(~NodeIndex{0});

    /// A pool over `capacity` nodes; the memory must outlive the pool and every tree in it.
    constexpr NodePool(Node* memory, std::uint32_t capacity) : NodePool(memory, memory, capacity, 0) {}

    /// A read-only pool over `count` nodes, all in use; a greater count than max_capacity is clipped. append
    /// answers pool_exhausted, compact pool_read_only if there is a node, and roll_back does nothing.
    static constexpr NodePool over(const Node* nodes, std::uint32_t count) {
        return NodePool(nodes, nullptr, count, count);
    }

    NodePool(const NodePool&) = delete;
    NodePool& operator=(const NodePool&) = delete;

    constexpr std::uint32_t capacity() const { return capacity_; }
    constexpr std::uint32_t used() const { return used_; }       ///< nodes in use now; also the mark
    constexpr std::uint32_t peak() const { return peak_; }       ///< the most nodes ever in use
    constexpr std::uint32_t refused() const { return refused_; } ///< appends refused for want of room

    constexpr const Node& at(NodeIndex index) const {
        OSEM_ASSERT(index < used_);
        return nodes_[index];
    }

    /// The node of grey child k of `parent`. Precondition: child k is grey.
    constexpr const Node& child(const Node& parent, unsigned k) const {
        const auto before = static_cast<std::uint8_t>(parent.grey() & ((1U << k) - 1U));
        return at(static_cast<NodeIndex>(parent.first() + count_bits(before)));
    }

    /// Writes `count` nodes in a row. Status: ok, with the first one's index; pool_exhausted, with nothing
    /// written. Cost: O(count).
    Status append(const Node* nodes, std::uint32_t count, NodeIndex& first);

    /// Forgets every node at or above `mark`, a former value of used(). Trees made since are gone.
    void roll_back(std::uint32_t mark);

  private:
    friend class Compactor;
    friend class TreeBuilder;
    /// Room for so many more nodes, which are in use now; or null. Precondition: count > 0.
    Node* extend(std::uint32_t count, NodeIndex& first);
    constexpr NodePool(const Node* nodes, Node* memory, std::uint32_t capacity, std::uint32_t used)
        : nodes_(nodes), memory_(memory), capacity_(clipped(capacity)), used_(clipped(used)), peak_(used_) {}
    static constexpr std::uint32_t clipped(std::uint32_t count) {
        return count < max_capacity ? count : max_capacity;
    }
    constexpr bool read_only() const { return memory_ != nodes_; }

    const Node* nodes_;
    Node* memory_; ///< the same nodes to write to; null in a read-only pool
    std::uint32_t capacity_;
    std::uint32_t used_;
    std::uint32_t peak_;
    std::uint32_t refused_ = 0;
};

/// A pool with its memory in itself. Its constructor runs at start-up (it is not constexpr on purpose): so a
/// static pool is zero-initialised memory, and its nodes take no place in the flash image.
template <std::uint32_t Capacity>
class StaticNodePool : public NodePool {
    static_assert(Capacity > 0 && Capacity <= NodePool::max_capacity, "capacity outside the index range");

  public:
    StaticNodePool() : NodePool(storage_, Capacity) {}

  private:
    Node storage_[Capacity];
};

} // namespace osem

#endif
