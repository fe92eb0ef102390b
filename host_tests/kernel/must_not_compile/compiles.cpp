// The twin of the files beside it: all that they get wrong, put right. It does compile.
#define OSEM_ASSERT(condition) ((condition) ? static_cast<void>(0) : __builtin_trap())
#include "osem/bounded.hpp"
#include "osem/convert.hpp"
#include "osem/lattice.hpp"
#include "osem/node_pool.hpp"

using Wide = osem::Bounded<0, (std::int64_t{1} << 31)>;
auto product(Wide a, Wide b) { return a * b; }

using Widest = osem::Bounded<0, INT64_MAX - 1>;
auto sum(Widest a, osem::Bounded<0, 1> b) { return a + b; }

using Lowest = osem::Bounded<INT64_MIN + 1, 0>;
auto difference(Lowest a, osem::Bounded<0, 1> b) { return a - b; }

osem::Bounded<0, 6> widened(osem::Bounded<0, 5> narrow) { return narrow; }
osem::Bounded<-1, 5> widened_below(osem::Bounded<0, 5> narrow) { return narrow; }
osem::Bounded<0, 5> bounded(int value) { return osem::Bounded<0, 5>::claim(value); }
int plain(osem::Bounded<0, 5> value) { return value.value(); }
auto least() { return osem::Bounded<0, 0>::claim(0); }
constexpr auto true_claim = osem::Bounded<0, 5>::claim(5);
static_assert(true_claim.value() == 5);
auto sum_of_plane_values(osem::PlaneValue value, osem::VertexDifference d) { return value + d; }

osem::Status begin(osem::Conversion& job, const osem::CheckedSolid& solid) {
    return job.begin(solid, osem::ConvertOptions{}, nullptr, 0, nullptr);
}

const osem::NodePool& same(const osem::NodePool& pool) { return pool; }
auto capacity() { return osem::StaticNodePool<1>().capacity(); }
std::uint8_t read(const osem::NodePool& pool) { return pool.at(0).may; }
