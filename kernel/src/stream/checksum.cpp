#include "osem/checksum.hpp"

#include "stream/codes.hpp"
#include "stream/crc.hpp"
#include "tree/unaligned.hpp"

namespace osem {

namespace {

// The polynomial divides x^1123 + x^198 + x^64 + x^24 + 1, and so the same with eight times the exponents,
// which is its eighth power: a byte is put out, and the remainder stays, where those that come 925, 1059,
// 1099 and 1123 bytes later are inverted by it. There are sparse multiples whose bytes come sooner; but parts
// that look ahead wait for what has just been stored, where it is loaded in other pieces.
static_assert((shifted_out(1, 1123) ^ shifted_out(1, 198) ^ shifted_out(1, 64) ^ shifted_out(1, 24)) == 1,
              "it divides that");
constexpr unsigned exponents[] = {24, 64, 198};

// A remainder as it was 1123 bytes before.
constexpr std::uint32_t before_reach(std::uint32_t remainder) {
    std::uint32_t before = 0x286b5dd1U; // what the highest bit was then, and after that the lower ones
    std::uint32_t sum = 0;
    for (unsigned bit = 32; bit-- > 0; before = shifted_out(before, 1)) {
        sum ^= before & (0U - (remainder >> bit & 1U));
    }
    return sum;
}
static_assert(before_reach(shifted_out(0x12345679U, 8 * 1123)) == 0x12345679U, "it is an inverse");

// Puts out as many bytes as `Count` words have at a time, of `count` bytes. `to` is where the oldest ones are
// that are added to them; what they become is stored `reach` behind it.
template <unsigned Count>
[[gnu::always_inline]] inline void put_out(const std::uint8_t*& bytes, std::size_t& count, std::uint8_t*& to,
                                           std::size_t reach) {
    constexpr std::size_t size = std::size_t{Count} * codes_size;
    for (; count >= size; count -= size) {
        Codes words[Count];
        for (unsigned i = 0; i < Count; ++i) {
            const std::size_t at = std::size_t{i} * codes_size;
            words[i] = codes_at(bytes + at, 0) ^ codes_at(to + at, 0);
            for (const unsigned exponent : exponents) words[i] ^= codes_at(to + exponent + at, 0);
        }
        for (unsigned i = 0; i < Count; ++i) put_word(to + reach + std::size_t{i} * codes_size, words[i]);
        bytes += size;
        to += size;
    }
}

} // namespace

void TableChecksum::append(const std::uint8_t* bytes, std::size_t count) {
    crc_ = crc_append(crc_, bytes, count);
}

void SparseChecksum::append(const std::uint8_t* bytes, std::size_t count) {
    while (count != 0) {
        if (at_ == room) make_room();
        std::size_t taken = room - at_;
        if (count < taken) taken = count;
        std::uint8_t* to = put_out_ + at_;
        count -= taken;
        at_ += static_cast<unsigned>(taken);
        put_out<4>(bytes, taken, to, reach);
        put_out<1>(bytes, taken, to, reach);
        for (; taken != 0; --taken, ++to) {
            unsigned sum = *bytes++ ^ *to;
            for (const unsigned exponent : exponents) sum ^= to[exponent];
            to[reach] = static_cast<std::uint8_t>(sum);
        }
    }
}

// The last bytes put out take the place of the first ones; each word is stored behind where the next is
// loaded.
void SparseChecksum::make_room() {
    constexpr unsigned size = codes_size;
    unsigned i = 0;
    for (; i + size <= reach; i += size) put_word(put_out_ + i, codes_at(put_out_ + room + i, 0));
    for (; i < reach; ++i) put_out_[i] = put_out_[room + i];
    at_ = 0;
}

// The bytes that all those put out are still to be added to, as if there were no others; they are taken off
// again.
std::uint32_t SparseChecksum::value() const {
    constexpr unsigned piece = 64;
    const std::uint8_t* const last = put_out_ + at_;
    std::uint8_t ahead[piece];
    std::uint32_t crc = ~std::uint32_t{0};
    for (unsigned place = 0; place < reach; ++place) {
        unsigned sum = last[place];
        for (const unsigned exponent : exponents) {
            if (place + exponent < reach) sum ^= last[place + exponent];
        }
        ahead[place % piece] = static_cast<std::uint8_t>(sum);
        const bool full = place % piece == piece - 1 || place == reach - 1;
        if (full) crc = crc_append(crc, ahead, place % piece + 1);
    }
    return ~before_reach(~crc);
}

} // namespace osem
