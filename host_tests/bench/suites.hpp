// Registers what is measured. Names are theme/solid/cells along an axis/method; all methods run on one
// thread, but for those that say otherwise.
#ifndef OSEM_BENCH_SUITES_HPP
#define OSEM_BENCH_SUITES_HPP

#include <string>

#include <benchmark/benchmark.h>

#include "bench/boolean_agreement.hpp"

namespace osem::bench {

/// The name of a conversion's benchmarks up to the method.
inline std::string conversion_name(const std::string& solid, int depth) {
    return "convert/" + solid + "/" + std::to_string(1 << depth) + "/";
}

/// The name of a Boolean's benchmarks up to the method.
inline std::string boolean_name(const Pair& pair, Operator op) {
    constexpr const char* themes[] = {"union/", "intersection/", "difference/", "xor/"};
    return themes[static_cast<int>(op)] + pair.a + "+" + pair.b + "/" + std::to_string(1 << pair.depth) + "/";
}

void add_conversions(const std::string& solid, int depth);
void add_threads(const std::string& solid, int depth);
void add_boolean(const Pair& pair, Operator op);

/// These are there where their libraries are.
void add_vdb_conversion(const std::string& solid, int depth);
void add_vdb_boolean(const Pair& pair, Operator op);
void add_cgal_boolean(const Pair& pair, Operator op);

} // namespace osem::bench

#endif
