// Build options of the kernel. Set them on the compiler's command line, the same for every file of a program.
#ifndef OSEM_CONFIG_HPP
#define OSEM_CONFIG_HPP

// Width of a child index in bits: 32 (nodes of 6 bytes, up to 2^32 - 1 of them in a pool) or
// 16 (nodes of 4 bytes, up to 65,535 of them in a pool).
#ifndef OSEM_NODE_INDEX_BITS
#define OSEM_NODE_INDEX_BITS 32
#endif

// Marks the types whose layout depends on that width, so that a program of files with different widths does
// not link (GCC and Clang).
#if OSEM_NODE_INDEX_BITS == 16 && defined(__GNUC__)
#define OSEM_OF_INDEX_WIDTH __attribute__((abi_tag("index16")))
#else
#define OSEM_OF_INDEX_WIDTH
#endif

// 1: the checksums of streams by tables of 8 KB, eight bytes at a time; 0: by a table of 64 bytes. With wide
// registers (register_word.hpp) it is asked for headers and the last bytes of payloads alone, and 1 gains
// nothing.
#ifndef OSEM_FAST_CRC
#define OSEM_FAST_CRC 0
#endif

// Contract check: a false condition is a bug in the caller, never bad data. Expands to nothing unless the
// program defines it, for example as its own trap or as the hosted assert.
#ifndef OSEM_ASSERT
#define OSEM_ASSERT(condition) static_cast<void>(0)
#endif

#endif
