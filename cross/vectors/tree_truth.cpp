#include "tree_truth.hpp"

#include <algorithm>
#include <stdexcept>

#include "format.hpp"

namespace vectors {

using osem::Colour;

namespace {

std::uint64_t morton(const osem::Point& cell) {
    std::uint64_t code = 0;
    for (int bit = 0; bit < osem::lattice_bits; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            code |= static_cast<std::uint64_t>((cell.at[axis] >> bit) & 1) << (3 * bit + axis);
        }
    }
    return code;
}

bool apart(const osem::Octant& a, const osem::Octant& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.corner.at[axis] + a.side() <= b.corner.at[axis]) return true;
        if (b.corner.at[axis] + b.side() <= a.corner.at[axis]) return true;
    }
    return false;
}

unsigned may_bit(Colour colour) { return colour == Colour::black || colour == Colour::boundary ? 1 : 0; }
unsigned must_bit(Colour colour) { return colour == Colour::black || colour == Colour::grey ? 1 : 0; }

} // namespace

ColouredCells coloured(const oracle::CellGrid& grid, osem::LeafRule leaves, osem::WindingRule winding) {
    ColouredCells cells{grid.window(), grid.depth(), {}};
    for (std::size_t i = 0; i < grid.size(); ++i) {
        cells.colours.push_back(oracle::colour_of(grid[i], leaves, winding));
    }
    return cells;
}

TreeTruth::TreeTruth(const ColouredCells& cells) : depth_(cells.depth) {
    const Colour root = fold(osem::root_octant, cells);
    if (next_cell_ != cells.colours.size()) throw std::logic_error("the fold left cells out");
    if (root == Colour::grey) return;
    // A root of one colour still is a node: of eight children that are.
    nodes_.push_back(
        {static_cast<std::uint8_t>(0xff * may_bit(root)), static_cast<std::uint8_t>(0xff * must_bit(root))});
}

// Children first; eight equal leaves are one.
Colour TreeTruth::fold(const osem::Octant& octant, const ColouredCells& cells) {
    const bool outside = apart(octant, cells.window);
    if (outside || octant.level == depth_) {
        const Colour colour = outside ? Colour::white : cells.colours.at(next_cell_++);
        leaves_.push_back({octant.level, colour, morton(octant.corner)});
        return colour;
    }
    const std::size_t node = nodes_.size();
    const std::size_t first_leaf = leaves_.size();
    nodes_.push_back({0, 0});
    unsigned may = 0;
    unsigned must = 0;
    bool equal = true;
    Colour first = Colour::grey;
    for (unsigned k = 0; k < 8; ++k) {
        const Colour colour = fold(octant.child(k), cells);
        if (k == 0) first = colour;
        equal = equal && colour == first && colour != Colour::grey;
        may |= may_bit(colour) << k;
        must |= must_bit(colour) << k;
    }
    if (equal) {
        nodes_.resize(node);
        leaves_.resize(first_leaf);
        leaves_.push_back({octant.level, first, morton(octant.corner)});
        return first;
    }
    nodes_[node] = {static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must)};
    return Colour::grey;
}

std::uint64_t TreeTruth::leaves_of(Colour colour) const {
    return static_cast<std::uint64_t>(std::count_if(leaves_.begin(), leaves_.end(),
                                                    [&](const Leaf& leaf) { return leaf.colour == colour; }));
}

std::uint64_t TreeTruth::volume_of(Colour colour) const {
    std::uint64_t volume = 0;
    for (const Leaf& leaf : leaves_) {
        if (leaf.colour == colour) volume += std::uint64_t{1} << (3 * (osem::lattice_bits - leaf.level));
    }
    return volume;
}

// FNV-1a of 64 bits.
std::uint64_t TreeTruth::digest() const {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const Masks& node : nodes_) {
        hash = (hash ^ node.may) * 0x100000001b3;
        hash = (hash ^ node.must) * 0x100000001b3;
    }
    return hash;
}

// Every leaf is at its place in Morton order; before the first leaf of a grey octant stands that octant. An
// octant of level l begins where 3 * (lattice_bits - l) bits of the position are 0, and it is grey when the
// leaf there is deeper.
std::vector<Colour> TreeTruth::preorder() const {
    std::vector<Colour> colours;
    for (const Leaf& leaf : leaves_) {
        int level = 0;
        while (leaf.first % (std::uint64_t{1} << (3 * (osem::lattice_bits - level))) != 0) ++level;
        for (; level < leaf.level; ++level) colours.push_back(Colour::grey);
        colours.push_back(leaf.colour);
    }
    return colours;
}

// The stream by the words of osem/stream.hpp.
std::uint32_t TreeTruth::stream_crc(osem::LeafRule rule) const {
    Bytes stream;
    for (const char letter : {'O', 'S', 'E', 'M'}) stream.u8(static_cast<std::uint8_t>(letter));
    stream.u8(2);
    stream.u8(static_cast<std::uint64_t>(depth_));
    stream.u8(rule == osem::LeafRule::centre ? 1 : 0);
    stream.u8(0);
    for (const std::uint64_t number : osem::cross::stream_frame) stream.u64(number);
    stream.u32(leaves_.size() == 1 ? 0 : nodes_.size());
    stream.u32(crc_32(stream.data()));
    Bytes payload;
    unsigned byte = 0;
    unsigned used = 0;
    for (const Colour colour : preorder()) {
        byte |= static_cast<unsigned>(colour) << used;
        used += 2;
        if (used < 8) continue;
        payload.u8(byte);
        byte = 0;
        used = 0;
    }
    if (used != 0) payload.u8(byte);
    stream.append(payload);
    stream.u32(crc_32(payload.data()));
    return crc_32(stream.data());
}

void TreeTruth::put_query(Bytes& body, const osem::Point& cell) const {
    body.point(cell);
    for (const std::int32_t c : cell.at) {
        if (0 <= c && c < osem::root_side) continue;
        body.u8(static_cast<std::uint64_t>(osem::Status::point_off_root));
        body.u8(0);
        return;
    }
    const auto behind =
        std::upper_bound(leaves_.begin(), leaves_.end(), morton(cell),
                         [](std::uint64_t position, const Leaf& leaf) { return position < leaf.first; });
    const Leaf& leaf = *(behind - 1);
    body.u8(static_cast<std::uint64_t>(osem::Status::ok));
    body.u8(osem::cross::encoded(leaf.level, leaf.colour));
}

void TreeTruth::put(Bytes& body, osem::LeafRule rule, Random& random) const {
    const std::uint64_t inner = volume_of(Colour::black);
    body.u32(nodes_.size());
    body.u32(leaves_of(Colour::white));
    body.u32(leaves_of(Colour::black));
    body.u32(leaves_of(Colour::boundary));
    body.u64(inner);
    body.u64(inner + volume_of(Colour::boundary));
    body.u64(digest());
    body.u32(stream_crc(rule));
    body.u32(leaves_.size());
    for (const Leaf& leaf : leaves_) body.u8(osem::cross::encoded(leaf.level, leaf.colour));

    constexpr std::int32_t last = osem::root_side - 1;
    std::vector<osem::Point> cells = {{{0, 0, 0}}, {{last, last, last}}, {{0, -1, 0}}, {{0, 0, last + 1}}};
    for (int i = 0; i < 6; ++i) {
        const std::int32_t x = random.between(0, last);
        const std::int32_t y = random.between(0, last);
        const std::int32_t z = random.between(0, last);
        cells.push_back({{x, y, z}});
    }
    body.u8(cells.size());
    for (const osem::Point& cell : cells) put_query(body, cell);
}

} // namespace vectors
