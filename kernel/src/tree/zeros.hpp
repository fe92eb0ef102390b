// Whether the part has an instruction that counts zeros, so that __builtin_ctz is no call of a function.
#ifndef OSEM_TREE_ZEROS_HPP
#define OSEM_TREE_ZEROS_HPP

#if defined(__ARM_FEATURE_CLZ) || defined(__x86_64__) || defined(__i386__) || defined(__aarch64__)
#define OSEM_COUNTS_ZEROS 1
#else
#define OSEM_COUNTS_ZEROS 0
#endif

#endif
