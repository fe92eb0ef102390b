#include "osem/stream_query.hpp"

#include "osem/stream_cursor.hpp"
#include "stream/code_runs.hpp"
#include "stream/codes.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// Which child, of a level, of an octant holds the cell.
unsigned child_at(const Point& cell, int level) {
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        child |= (static_cast<unsigned>(cell.at[axis]) >> (lattice_bits - level) & 1U) << axis;
    }
    return child;
}

} // namespace

StreamPointOutcome leaf_at(const Source& stream, const Point& cell) {
    StreamPointOutcome outcome = {{Status::point_off_root, Leaf{root_octant, Colour::boundary}, 0}, 0};
    for (const std::int32_t coordinate : cell.at) {
        if (coordinate < 0 || coordinate >= root_side) return outcome;
    }
    StreamCursor cursor;
    cursor.begin(stream);
    // Into the octants that hold the cell, past all others: each of their children but one.
    int level = 0;
    for (unsigned before = 0; !cursor.done();) {
        ++outcome.point.visited;
        const bool holds = cursor.level() == level && before-- == 0;
        if (holds && cursor.colour() != Colour::grey) {
            outcome.point.leaf = Leaf{cursor.octant(), cursor.colour()};
            break;
        }
        if (holds) before = child_at(cell, ++level);
        holds ? cursor.next() : stream.checked ? cursor.skip() : cursor.next_or_leaves();
    }
    outcome.point.status = cursor.status();
    outcome.offset = cursor.offset();
    return outcome;
}

namespace {

void add_leaf(Measures& m, Colour colour, std::uint64_t cells) {
    if (colour == Colour::grey) {
        ++m.nodes;
    } else if (colour == Colour::white) {
        ++m.white_leaves;
    } else if (colour == Colour::black) {
        ++m.black_leaves;
        m.inner_volume += cells;
        m.outer_volume += cells;
    } else {
        ++m.boundary_leaves;
        m.outer_volume += cells;
    }
}

// The masks of the octant's children; of their codes if they are all leaves, else by a look ahead. A fault
// ends the walk: a source may refuse the look ahead and answer afterwards.
Node masks_at(StreamCursor& cursor) {
    Node node = Node::uniform(Colour::white);
    if (cursor.colour() != Colour::grey) return Node::uniform(cursor.colour());
    std::uint16_t codes = 0;
    if (cursor.leaf_children(codes)) {
        node.may = may_of(codes);
        node.must = must_of(codes);
        return node;
    }
    StreamCursor ahead = cursor;
    for (unsigned k = 0; k < 8; ++k) {
        k == 0 ? ahead.next() : ahead.skip();
        if (ahead.done()) {
            cursor = ahead;
            break;
        }
        assign_colour(node.may, node.must, k, ahead.colour());
    }
    return node;
}

} // namespace

StreamMeasures measure(const Source& stream) {
    StreamMeasures outcome = {Status::ok, 0, {}};
    StreamCursor cursor;
    for (cursor.begin(stream); !cursor.done(); cursor.next()) {
        add_leaf(outcome.measures, cursor.colour(), volume_at(cursor.level()));
    }
    if (outcome.measures.nodes == 0) outcome.measures.nodes = 1; // the top of a tree is a node in any case
    outcome.status = cursor.status();
    outcome.offset = cursor.offset();
    return outcome;
}

StreamDigest digest(const Source& stream) {
    // FNV-1a, 64 bits, over the bytes may and must of each node in preorder, as of a tree in a pool.
    constexpr std::uint64_t prime = 0x100000001b3U;
    std::uint64_t hash = 0xcbf29ce484222325U;
    StreamCursor cursor;
    for (cursor.begin(stream); !cursor.done(); cursor.next_or_leaves()) {
        if (cursor.level() > 0 && cursor.colour() != Colour::grey) continue;
        const Node node = masks_at(cursor);
        hash = (hash ^ node.may) * prime;
        hash = (hash ^ node.must) * prime;
        if (cursor.done()) break;
    }
    return {cursor.status(), cursor.offset(), hash};
}

StreamComparison same_leaves(const Source& a, const Source& b) {
    StreamCursor in_a;
    StreamCursor in_b;
    in_a.begin(a);
    in_b.begin(b);
    bool same = true;
    while (!in_a.done() && !in_b.done()) {
        std::uint16_t codes_a = 0;
        std::uint16_t codes_b = 0;
        same = in_a.colour() == in_b.colour() && in_a.leaf_children(codes_a) == in_b.leaf_children(codes_b) &&
               codes_a == codes_b;
        if (!same) break;
        in_a.next_or_leaves();
        in_b.next_or_leaves();
    }
    const bool in_second = in_a.status() == Status::ok && in_b.status() != Status::ok;
    const StreamCursor& faulty = in_second ? in_b : in_a;
    // Without a fault both end at once, as far as they are the same.
    return {faulty.status(), in_second, faulty.offset(), same && faulty.status() == Status::ok};
}

StreamComparison same_leaves(const Source& a, const Octree& b) {
    StreamCursor in_a;
    in_a.begin(a);
    const auto compare = [&in_a](std::uint32_t codes, unsigned count) {
        for (; count != 0; --count, codes >>= 2) {
            if (in_a.done() || in_a.colour() != static_cast<Colour>(codes & 3U)) return false;
            in_a.next();
        }
        return true;
    };
    const bool same = each_run_of_codes(b, compare); // as far as they are, both are as long
    return {in_a.status(), false, in_a.offset(), same && in_a.status() == Status::ok};
}

} // namespace osem
