// Whether a part guesses at branches far ahead, so that a wrong guess costs more than some needless work.
#ifndef OSEM_TREE_GUESSES_HPP
#define OSEM_TREE_GUESSES_HPP

namespace osem {

/// Parts of 64 bits do; on others what is to be done is decided by a branch, and nothing is done in vain.
#if defined(__LP64__)
constexpr bool guesses_cost_much = true;
#else
constexpr bool guesses_cost_much = false;
#endif

} // namespace osem

#endif
