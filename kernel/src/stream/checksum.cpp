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

// Where bytes are put out, and those that are added to them.
struct Places {
    std::uint8_t* oldest;
    const std::uint8_t* others[3];
};

// Puts out as many bytes as `Count` words have at a time, of `count` bytes.
template <unsigned Count>
[[gnu::always_inline]] inline void put_out(const std::uint8_t*& bytes, std::size_t& count, Places& places) {
    constexpr std::size_t size = std::size_t{Count} * codes_size;
    for (; count >= size; count -= size) {
        Codes words[Count];
        for (unsigned i = 0; i < Count; ++i) {
            const std::size_t at = std::size_t{i} * codes_size;
            words[i] = codes_at(bytes + at, 0) ^ codes_at(places.oldest + at, 0);
            for (const std::uint8_t* other : places.others) words[i] ^= codes_at(other + at, 0);
        }
        for (unsigned i = 0; i < Count; ++i) put_word(places.oldest + std::size_t{i} * codes_size, words[i]);
        bytes += size;
        places.oldest += size;
        for (const std::uint8_t*& other : places.others) other += size;
    }
}

} // namespace

void TableChecksum::append(const std::uint8_t* bytes, std::size_t count) {
    crc_ = crc_append(crc_, bytes, count);
}

void SparseChecksum::append(const std::uint8_t* bytes, std::size_t count) {
    while (count != 0) {
        Places places = {put_out_ + at_, {}};
        std::size_t taken = reach - at_;
        if (count < taken) taken = count;
        for (unsigned i = 0; i < 3; ++i) {
            const unsigned behind = at_ + exponents[i];
            const unsigned at = behind < reach ? behind : behind - reach;
            places.others[i] = put_out_ + at;
            if (reach - at < taken) taken = reach - at;
        }
        count -= taken;
        at_ += static_cast<unsigned>(taken);
        if (at_ == reach) at_ = 0;
        put_out<4>(bytes, taken, places);
        put_out<1>(bytes, taken, places);
        for (; taken != 0; --taken) {
            unsigned sum = *bytes++ ^ *places.oldest;
            for (const std::uint8_t*& other : places.others) sum ^= *other++;
            *places.oldest++ = static_cast<std::uint8_t>(sum);
        }
    }
}

// The bytes that all those put out are still to be added to, as if there were no others; they are taken off
// again.
std::uint32_t SparseChecksum::value() const {
    constexpr unsigned piece = 64;
    const auto put_out_at = [&](unsigned place) {
        const unsigned at = at_ + place;
        return put_out_[at < reach ? at : at - reach];
    };
    std::uint8_t ahead[piece];
    std::uint32_t crc = ~std::uint32_t{0};
    for (unsigned place = 0; place < reach; ++place) {
        unsigned sum = put_out_at(place);
        for (const unsigned exponent : exponents) {
            if (place + exponent < reach) sum ^= put_out_at(place + exponent);
        }
        ahead[place % piece] = static_cast<std::uint8_t>(sum);
        const bool full = place % piece == piece - 1 || place == reach - 1;
        if (full) crc = crc_append(crc, ahead, place % piece + 1);
    }
    return ~before_reach(~crc);
}

} // namespace osem
