#include "support/stream_samples.hpp"

#include <algorithm>

namespace osem::tests {

namespace {

Part joined(std::vector<Part> children) {
    const Colour first = children.front().colour;
    const bool one_leaf =
        first != Colour::grey && std::all_of(children.begin(), children.end(),
                                             [first](const Part& child) { return child.colour == first; });
    if (one_leaf) return {first, {}};
    return {Colour::grey, std::move(children)};
}

Part random_part(int levels, unsigned grey, const std::vector<Colour>& palette, std::mt19937& random) {
    if (levels == 0 || random() % 16 >= grey) return {palette[random() % palette.size()], {}};
    std::vector<Part> children;
    for (unsigned k = 0; k < 8; ++k) children.push_back(random_part(levels - 1, grey, palette, random));
    return joined(std::move(children));
}

void append_colours(std::vector<Colour>& colours, const Part& part) {
    colours.push_back(part.colour);
    for (const Part& child : part.children) append_colours(colours, child);
}

} // namespace

Part grey_part(int levels, unsigned grey, const std::vector<Colour>& palette, std::mt19937& random) {
    std::vector<Part> children;
    for (unsigned k = 0; k < 8; ++k) children.push_back(random_part(levels - 1, grey, palette, random));
    return joined(std::move(children));
}

Part bushy_part(int levels, const std::vector<Colour>& palette, std::mt19937& random) {
    std::vector<Part> children;
    const std::size_t greys = random() % 9;
    const std::size_t chosen = random() % 8;
    for (std::size_t k = 0; k < 8; ++k) {
        const bool grey = levels > 2 ? random() % 8 < 3 || k == chosen : (k * 5 + chosen) % 8 < greys;
        children.push_back(levels > 1 && grey ? bushy_part(levels - 1, palette, random)
                                              : Part{palette[random() % palette.size()], {}});
    }
    Part part = joined(std::move(children));
    return part.colour == Colour::grey ? part : bushy_part(levels, palette, random);
}

Part combined(Operator op, const Part& a, const Part& b) {
    if (a.children.empty() && b.children.empty()) return {combine_colours(op, a.colour, b.colour), {}};
    std::vector<Part> children;
    for (std::size_t k = 0; k < 8; ++k) {
        children.push_back(
            combined(op, a.children.empty() ? a : a.children[k], b.children.empty() ? b : b.children[k]));
    }
    return joined(std::move(children));
}

std::vector<Colour> colours_of(const Part& part) {
    std::vector<Colour> colours;
    append_colours(colours, part);
    return colours;
}

Sample sample_of(std::uint32_t seed) {
    std::mt19937 random(seed);
    const int depth = 1 + static_cast<int>(random() % max_depth);
    const unsigned grey = depth > 7 ? 2 : 3 + static_cast<unsigned>(random() % (depth > 4 ? 3 : 10));
    return {grey_part(depth, grey, random() % 2 == 0 ? two_colours : three_colours, random), depth};
}

Place::Place(const Bytes& bytes, Known known, bool read)
    : exact(bytes), index(known == Known::indexed ? index_of(bytes) : Bytes()), reader(bytes) {
    reader.checked = known != Known::nothing;
    reader.index = index.empty() ? nullptr : index.data();
    source = read ? reader.source() : source_of(exact, reader.checked);
    source.index = reader.index;
}

} // namespace osem::tests
