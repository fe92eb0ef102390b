// How much stack a call takes, measured: the free stack below the caller is painted, and what the call has
// overwritten is counted afterwards.
#ifndef OSEM_CROSS_PAINT_STACK_USED_HPP
#define OSEM_CROSS_PAINT_STACK_USED_HPP

#include <cstdint>

extern "C" std::uint32_t stack_limit[]; // the linker script's

namespace osem::cross {

constexpr std::uint32_t paint = 0xa5c3965aU;
constexpr std::uint32_t no_paint_left =
    ~std::uint32_t{0}; ///< the call has come to the end of what was painted

/// Bytes of stack that `call`, a lambda, takes below its caller's frame. All of this is inlined into the
/// caller, the lambda because it is called once, so that no frame of ours is counted. (If the compiler
/// did not, a measured stack would be over its bound.) The loops are volatile, so that they do not become
/// calls of memset.
template <class Call>
[[gnu::always_inline]] inline std::uint32_t stack_used_by(Call call) {
    volatile std::uint32_t* top = nullptr;
    asm volatile("mov %0, sp" : "=r"(top));
    constexpr std::uintptr_t painted_bytes = 16384; // many times what any function should take
    const bool short_stack =
        reinterpret_cast<std::uintptr_t>(top) - painted_bytes < reinterpret_cast<std::uintptr_t>(stack_limit);
    volatile std::uint32_t* const bottom = short_stack ? stack_limit : top - painted_bytes / 4;
    for (volatile std::uint32_t* at = bottom; at != top; ++at) {
        *at = paint;
    }
    call();
    volatile std::uint32_t* lowest = bottom;
    while (lowest != top && *lowest == paint) {
        ++lowest;
    }
    return lowest == bottom ? no_paint_left : static_cast<std::uint32_t>(top - lowest) * 4;
}

/// Makes the compiler believe that a result is used, where it stands, without a copy.
template <class Result>
[[gnu::always_inline]] inline void use(const Result& result) {
    asm volatile("" : : "r"(&result) : "memory");
}

} // namespace osem::cross

#endif
