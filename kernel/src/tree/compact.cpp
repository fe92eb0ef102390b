#include "osem/octree.hpp"

#include "tree/masks.hpp"

namespace osem {

// Sliding compaction with threaded references (after Morris, "A Time- and Space-Efficient Garbage
// Compaction Algorithm", CACM 21(8), 1978). Child indices only ever point downwards, so one descending pass
// marks everything, and a second one meets all references to a group before the group itself. That pass
// chains the nodes that refer to a group through their own `first` fields, starting in the field of the
// group's first node: a value above the group's index is a link, one below it is the field's own content,
// so no further bit is needed.
class Compactor {
  public:
    Compactor(NodePool& pool, std::uint32_t* marks) : pool_(pool), marks_(marks) {}

    bool may_write() const { return !pool_.read_only(); }

    void run(Octree* trees, std::uint32_t tree_count) {
        for (std::uint32_t w = 0; w < compact_scratch(pool_.used_); ++w) marks_[w] = 0;
        for (std::uint32_t t = 0; t < tree_count; ++t) mark_children(trees[t].top);
        const std::uint32_t live = mark_reached();
        relink(live);
        for (std::uint32_t t = 0; t < tree_count; ++t) {
            if (trees[t].top.grey() != 0) set_first(trees[t].top, live_below(trees[t].top.first()));
        }
        slide();
    }

  private:
    bool marked(std::uint32_t i) const { return ((marks_[i / 32] >> (i % 32)) & 1U) != 0; }

    static void set_first(Node& node, std::uint32_t first) {
        node = Node::of(node.may, node.must, static_cast<NodeIndex>(first));
    }

    void mark_children(const Node& node) {
        const std::uint32_t count = count_bits(node.grey());
        for (std::uint32_t i = node.first(); i < node.first() + count; ++i) {
            marks_[i / 32] |= std::uint32_t{1} << (i % 32);
        }
    }

    std::uint32_t mark_reached() {
        std::uint32_t live = 0;
        for (std::uint32_t i = pool_.used_; i-- > 0;) {
            if (!marked(i)) continue;
            ++live;
            mark_children(pool_.memory_[i]);
        }
        return live;
    }

    void relink(std::uint32_t live) {
        Node* const nodes = pool_.memory_;
        for (std::uint32_t i = pool_.used_; i-- > 0;) {
            if (!marked(i)) continue;
            --live; // the index to which node i will slide
            std::uint32_t link = nodes[i].first();
            while (link > i) {
                const std::uint32_t next = nodes[link].first();
                set_first(nodes[link], live);
                link = next;
            }
            if (nodes[i].grey() == 0) {
                set_first(nodes[i], 0);
            } else {
                set_first(nodes[i], nodes[link].first());
                set_first(nodes[link], i);
            }
        }
    }

    std::uint32_t live_below(std::uint32_t index) const {
        std::uint32_t live = 0;
        for (std::uint32_t w = 0; w <= index / 32; ++w) {
            std::uint32_t word = marks_[w];
            if (w == index / 32) word &= (std::uint32_t{1} << (index % 32)) - 1;
            for (; word != 0; word >>= 8) live += count_bits(static_cast<std::uint8_t>(word));
        }
        return live;
    }

    void slide() {
        std::uint32_t to = 0;
        for (std::uint32_t from = 0; from < pool_.used_; ++from) {
            if (marked(from)) pool_.memory_[to++] = pool_.memory_[from];
        }
        pool_.used_ = to;
    }

    NodePool& pool_;
    std::uint32_t* marks_;
};

Status compact(NodePool& pool, Octree* trees, std::uint32_t tree_count, std::uint32_t* scratch,
               std::uint32_t scratch_size) {
    Compactor compactor(pool, scratch);
    if (!compactor.may_write()) return Status::pool_read_only;
    if (scratch_size < compact_scratch(pool.used())) return Status::scratch_too_small;
    for (std::uint32_t t = 0; t < tree_count; ++t) {
        if (trees[t].pool != &pool) return Status::pools_differ;
    }
    compactor.run(trees, tree_count);
    return Status::ok;
}

} // namespace osem
