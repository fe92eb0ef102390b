// Operands of Booleans, and the check that Osem's and the runs' results are one before any is timed.
#ifndef OSEM_BENCH_BOOLEAN_AGREEMENT_HPP
#define OSEM_BENCH_BOOLEAN_AGREEMENT_HPP

#include <cstdint>
#include <string>

#include "bench/osem_pair.hpp"
#include "bench/run_boolean.hpp"

namespace osem::bench {

/// The names of two solids, at one depth.
struct Pair {
    std::string a;
    std::string b;
    int depth = 0;

    friend bool operator==(const Pair& p, const Pair& q) {
        return p.a == q.a && p.b == q.b && p.depth == q.depth;
    }
};

struct RunPair {
    RunGrid a;
    RunGrid b;
};

RunPair runs_of(const Pair& pair);

/// The trees of a pair. They are kept until those of another pair are asked for: they take long to make, and
/// benchmarks of one pair follow each other.
OsemPair& trees_of(const Pair& pair, LeafRule leaves);

/// Combines trees in their pool and as streams, by both leaf rules, and runs. Ends the program unless the
/// streams are those of the pool's results, and the runs' cells are those of the centre tree, one by one;
/// returns their number.
std::uint64_t agreed_cells(const Pair& pair, Operator op);

} // namespace osem::bench

#endif
