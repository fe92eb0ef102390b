// What a feature is: the functions that a program of that feature calls. The feature's program is only a
// table of their addresses, and the linker keeps what the table reaches. The table is named as in C, so that
// the linker is told the same name whatever the types in it.
#ifndef OSEM_CROSS_FEATURES_ROOTS_HPP
#define OSEM_CROSS_FEATURES_ROOTS_HPP

template <class... Functions>
struct Roots {};

template <class First, class... Others>
struct Roots<First, Others...> {
    First first;
    Roots<Others...> others;
};

template <class... Functions>
constexpr Roots<Functions...> roots_of() {
    return {};
}

template <class First, class... Others>
constexpr Roots<First, Others...> roots_of(First first, Others... others) {
    return {first, roots_of(others...)};
}

#endif
