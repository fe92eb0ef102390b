#include "osem/checksum.hpp"

#include "stream/codes.hpp"
#include "stream/crc.hpp"
#include "stream/header.hpp"

namespace osem {

namespace {

// The polynomial divides x^300 + x^155 + x^117 + x^89 + 1: so a bit is put out, and the remainder stays,
// where those that come 145, 183, 211 and 300 bits later are inverted.
static_assert((shifted_out(1, 300) ^ shifted_out(1, 155) ^ shifted_out(1, 117) ^ shifted_out(1, 89)) == 1,
              "it divides that");

// A word is put out; what is then to be added to those behind it. None of its bits comes back in the next
// one.
template <class Word>
[[gnu::always_inline]] inline void put_out(Word word, Word* ahead) {
    ahead[0] = ahead[1];
    ahead[1] = ahead[2] ^ word << 17 ^ word << 55;
    ahead[2] = ahead[3] ^ word >> 47 ^ word >> 9 ^ word << 19;
    ahead[3] = ahead[4] ^ word >> 45 ^ word << 44;
    ahead[4] = word >> 20;
}

template <class Word>
void append_to(Word* state, const std::uint8_t* bytes, std::size_t count) {
    if constexpr (sizeof(Word) == 4) {
        *state = crc_append(*state, bytes, count);
    } else {
        Word ahead[] = {state[0], state[1], state[2], state[3], state[4]}; // in registers
        for (; count >= sizeof(Word); count -= sizeof(Word), bytes += sizeof(Word)) {
            put_out(codes_at(bytes, 0) ^ ahead[0], ahead);
        }
        if (count != 0) { // the first bytes of a word; then all moves up
            const auto bits = static_cast<unsigned>(8 * count);
            Word last = ahead[0];
            for (unsigned bit = 0; bit < bits; bit += 8) last ^= Word{*bytes++} << bit;
            put_out(last & ((Word{1} << bits) - 1), ahead);
            for (Word& word : ahead) {
                const Word next = word;
                word = last >> bits | next << (64 - bits);
                last = next;
            }
        }
        for (unsigned i = 0; i < 5; ++i) state[i] = ahead[i];
    }
}

// A remainder as it was five words before.
constexpr std::uint32_t five_words_before(std::uint32_t remainder) {
    std::uint32_t before = 0xebd369b3U; // what the highest bit was then, and after that the lower ones
    std::uint32_t sum = 0;
    for (unsigned bit = 32; bit-- > 0; before = shifted_out(before, 1)) {
        sum ^= before & (0U - (remainder >> bit & 1U));
    }
    return sum;
}
static_assert(five_words_before(shifted_out(0x12345679U, 5 * 64)) == 0x12345679U, "it is an inverse");

template <class Word>
std::uint32_t value_of(const Word* state) {
    if constexpr (sizeof(Word) == 4) {
        return *state;
    } else { // five words of 0s are appended, and taken off again
        std::uint8_t bytes[5 * sizeof(Word)];
        for (unsigned i = 0; i < 5; ++i) put_number(bytes + sizeof(Word) * i, state[i]);
        return ~five_words_before(~crc_append(~std::uint32_t{0}, bytes, sizeof bytes));
    }
}

} // namespace

void Checksum::append(const std::uint8_t* bytes, std::size_t count) { append_to(state_, bytes, count); }

std::uint32_t Checksum::value_of_words() const { return value_of(state_); }

} // namespace osem
