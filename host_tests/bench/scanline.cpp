#include "bench/scanline.hpp"

#include <algorithm>
#include <utility>

#include "bench/row_crossings.hpp"

namespace osem::bench {

namespace {

// A crossing: its cell doubled, plus 1 where the row leaves the solid. So at one cell entering comes first,
// and runs that touch are one.
constexpr std::uint32_t crossing_code(std::int64_t cell, bool enters) {
    return static_cast<std::uint32_t>(2 * cell) + (enters ? 0 : 1);
}

void sort_few(std::uint16_t* first, std::uint16_t* end) {
    if (end - first > 32) {
        std::sort(first, end);
        return;
    }
    for (std::uint16_t* next = first + 1; next < end; ++next) {
        const std::uint16_t code = *next;
        std::uint16_t* to = next;
        for (; to > first && to[-1] > code; --to) *to = to[-1];
        *to = code;
    }
}

// Writes the boundaries of one row from its crossings, which are sorted by the way; returns their end.
std::uint16_t* write_runs(std::uint16_t* code, std::uint16_t* end, std::uint16_t* to) {
    if (end - code == 2) { // mostly; the surface is closed, so one enters and the other leaves
        const auto [begin, behind] = std::minmax({code[0] / 2, code[1] / 2});
        to[0] = static_cast<std::uint16_t>(begin);
        to[1] = static_cast<std::uint16_t>(behind);
        return to + (begin < behind ? 2 : 0);
    }
    sort_few(code, end);
    std::int32_t winding = 0;
    std::uint16_t begin = 0;
    for (; code < end; ++code) {
        const auto cell = static_cast<std::uint16_t>(*code / 2);
        if (winding == 0) begin = cell;
        winding += (*code & 1U) == 0 ? 1 : -1;
        if (winding == 0 && begin < cell) {
            *to++ = begin;
            *to++ = cell;
        }
    }
    return to;
}

} // namespace

std::uint64_t RunGrid::cells() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < boundaries.size(); i += 2) {
        sum += boundaries[i + 1] - std::uint64_t{boundaries[i]};
    }
    return sum;
}

std::uint64_t BitGrid::cells() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t word : words) sum += static_cast<std::uint64_t>(__builtin_popcountll(word));
    return sum;
}

std::uint64_t Scanline::bytes() const {
    return crossings_.capacity() * sizeof crossings_[0] + sorted_.capacity() * sizeof sorted_[0];
}

void Scanline::convert(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles,
                       int depth, RunGrid& result) {
    result.side = 1U << depth;
    result.starts.assign(std::size_t{result.side} * result.side + 1, 0);
    const std::size_t count = cross(vertices, triangles, depth, result.starts.data());
    sort_into_rows(count, result.starts);
    join(count, result);
}

// Crossings as triangles come; those of each row are counted by the way.
std::size_t Scanline::cross(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles,
                            int depth, std::uint32_t* counts) {
    const Cells cells(depth);
    std::size_t count = 0;
    std::uint64_t row = 0;
    const auto span = [&](std::int64_t z, std::int64_t from, std::int64_t to) {
        const auto length = static_cast<std::size_t>(to - from);
        if (crossings_.size() - count < length) crossings_.resize(2 * (count + length));
        row = static_cast<std::uint64_t>((z << depth) + from);
    };
    const auto cross = [&](std::int64_t x, bool enters) {
        ++counts[row];
        crossings_[count++] = row++ << 32 | crossing_code(x, enters);
    };
    for (const host::Triangle& t : triangles) {
        RowCrossings(cells, vertices[t[0]], vertices[t[1]], vertices[t[2]]).visit(span, cross);
    }
    return count;
}

// Counts become starts, and each start moves to its row's end, which is the next row's start.
void Scanline::sort_into_rows(std::size_t count, std::vector<std::uint32_t>& counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : counts) sum += std::exchange(entry, sum);
    sorted_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        sorted_[counts[crossings_[i] >> 32]++] = static_cast<std::uint16_t>(crossings_[i]);
    }
}

// Each row's crossings become its runs, and each row's end the start of them.
void Scanline::join(std::size_t count, RunGrid& result) {
    result.boundaries.resize(count);
    std::uint16_t* to = result.boundaries.data();
    std::uint16_t* from = sorted_.data();
    for (std::size_t row = 0; row + 1 < result.starts.size(); ++row) {
        std::uint16_t* const end = sorted_.data() + result.starts[row];
        result.starts[row] = static_cast<std::uint32_t>(to - result.boundaries.data());
        to = write_runs(from, end, to);
        from = end;
    }
    result.boundaries.resize(static_cast<std::size_t>(to - result.boundaries.data()));
    result.starts.back() = static_cast<std::uint32_t>(result.boundaries.size());
}

void set_bits(std::uint64_t* words, unsigned begin, unsigned end) {
    const unsigned last_bit = end - 1;
    const unsigned first = begin / 64;
    const unsigned last = last_bit / 64;
    const std::uint64_t from = ~std::uint64_t{0} << (begin % 64);
    const std::uint64_t to = ~std::uint64_t{0} >> (63 - last_bit % 64);
    if (first == last) {
        words[first] |= from & to;
        return;
    }
    words[first] |= from;
    std::fill(words + first + 1, words + last, ~std::uint64_t{0});
    words[last] |= to;
}

void fill_bits(const RunGrid& runs, BitGrid& result) {
    const std::size_t row_words = runs.side / 64;
    const std::size_t rows = std::size_t{runs.side} * runs.side;
    result.side = runs.side;
    result.words.resize(rows * row_words);
    for (std::size_t row = 0; row < rows; ++row) {
        std::uint64_t* const words = result.words.data() + row * row_words;
        std::fill_n(words, row_words, 0);
        for (std::uint32_t i = runs.starts[row]; i < runs.starts[row + 1]; i += 2) {
            set_bits(words, runs.boundaries[i], runs.boundaries[i + 1]);
        }
    }
}

} // namespace osem::bench
