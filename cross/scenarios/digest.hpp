// A digest over numbers, the same on every architecture.
#ifndef OSEM_SCENARIOS_DIGEST_HPP
#define OSEM_SCENARIOS_DIGEST_HPP

#include <cstdint>

namespace osem::cross {

/// FNV-1a, 64 bits (Fowler, Noll, Vo), over the bytes of the numbers added, the lowest byte first.
class Digest {
  public:
    void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3U; }
    void add(std::uint64_t number) {
        for (int byte = 0; byte < 8; ++byte, number >>= 8) add_byte(static_cast<std::uint8_t>(number));
    }
    void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
    void add(std::uint32_t number) { add(std::uint64_t{number}); }
    void add(std::int32_t number) { add(std::int64_t{number}); }
    void add(std::uint8_t number) { add(std::uint64_t{number}); }
    void add(bool truth) { add(std::uint64_t{truth ? 1U : 0U}); }
    /// An enumeration by its number.
    template <class Enumeration>
    void add(Enumeration value) {
        add(static_cast<std::uint64_t>(value));
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// Numbers that look random: the multiplicative generator modulo 2^31 - 1 with 48271 (Park, Miller and
/// Stockmeyer, CACM 36(7), 1993).
class Random {
  public:
    explicit Random(std::uint32_t seed) : state_(seed) {}
    /// In [0, bound). Precondition: 0 < bound <= 2^21.
    std::int32_t below(std::int32_t bound) {
        state_ = static_cast<std::uint32_t>(std::uint64_t{state_} * 48271U % 0x7fffffffU);
        return static_cast<std::int32_t>(state_ % static_cast<std::uint32_t>(bound));
    }

  private:
    std::uint32_t state_;
};

} // namespace osem::cross

#endif
