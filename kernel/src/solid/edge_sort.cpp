#include "solid/edge_sort.hpp"

namespace osem {

// Quicksort that goes over to heapsort when its partitions are too often lopsided (after Musser,
// "Introspective Sorting and Selection Algorithms", Software: Practice and Experience 27(8), 1997).

namespace {

constexpr std::uint32_t small_range = 16;

void swap_edges(Edge& a, Edge& b) {
    const Edge c = a;
    a = b;
    b = c;
}

void insertion_sort(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    for (std::uint32_t i = 1; i < count; ++i) {
        const Edge edge = edges[i];
        std::uint32_t at = i;
        for (; at > 0 && order(edges[at - 1], edge) > 0; --at) {
            edges[at] = edges[at - 1];
        }
        edges[at] = edge;
    }
}

void sift_down(Edge* edges, std::uint32_t root, std::uint32_t count, const EdgeOrder& order) {
    const Edge sifted = edges[root];
    while (root < count / 2) { // count / 2 is the first without children
        std::uint32_t child = 2 * root + 1;
        if (child + 1 < count && order(edges[child], edges[child + 1]) < 0) ++child;
        if (order(sifted, edges[child]) >= 0) break;
        edges[root] = edges[child];
        root = child;
    }
    edges[root] = sifted;
}

void heapsort(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    for (std::uint32_t root = count / 2; root-- > 0;) {
        sift_down(edges, root, count, order);
    }
    for (std::uint32_t end = count; end-- > 1;) {
        swap_edges(edges[0], edges[end]);
        sift_down(edges, 0, end, order);
    }
}

Edge median(const Edge& a, const Edge& b, const Edge& c, const EdgeOrder& order) {
    const Edge& low = order(a, b) < 0 ? a : b;
    const Edge& high = order(a, b) < 0 ? b : a;
    if (order(c, low) < 0) return low;
    return order(c, high) < 0 ? c : high;
}

// Hoare's partition around the median of three: nothing on the left is above anything on the right, and
// neither part is empty. Returns the length of the left part. Precondition: count >= 3.
std::uint32_t partition(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    const Edge pivot = median(edges[0], edges[count / 2], edges[count - 1], order);
    std::uint32_t left = 0;
    std::uint32_t right = count - 1;
    for (;; ++left, --right) {
        while (order(edges[left], pivot) < 0) {
            ++left;
        }
        while (order(edges[right], pivot) > 0) {
            --right;
        }
        if (left >= right) return right + 1;
        swap_edges(edges[left], edges[right]);
    }
}

} // namespace

void sort_edges(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    struct Range {
        Edge* first;
        std::uint32_t count;
        int splits; // partitions allowed before heapsort takes over: twice what halving would take
    };
    int splits = 0;
    for (std::uint32_t halved = count; halved != 0; halved /= 2) {
        splits += 2;
    }
    // The longer part is put off and the shorter one taken, so the range in hand halves at least with each
    // entry: 32 entries are enough for 2^32 edges.
    Range put_off[32];
    int waiting = 0;
    Range range = {edges, count, splits};
    for (;;) {
        while (range.count > small_range && range.splits > 0) {
            const std::uint32_t left = partition(range.first, range.count, order);
            const Range low = {range.first, left, range.splits - 1};
            const Range high = {range.first + left, range.count - left, range.splits - 1};
            const bool low_is_longer = low.count > high.count;
            put_off[waiting++] = low_is_longer ? low : high;
            range = low_is_longer ? high : low;
        }
        range.count > small_range ? heapsort(range.first, range.count, order)
                                  : insertion_sort(range.first, range.count, order);
        if (waiting == 0) return;
        range = put_off[--waiting];
    }
}

} // namespace osem
