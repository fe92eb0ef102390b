// Point, measures, digest and equality of streams.
#include "features/roots.hpp"

#include "osem/stream_query.hpp"

namespace {

using LeafAt = osem::StreamPointOutcome (*)(const osem::Source&, const osem::Point&);
using Measure = osem::StreamMeasures (*)(const osem::Source&);
using Digest = osem::StreamDigest (*)(const osem::Source&);
using Same = osem::StreamComparison (*)(const osem::Source&, const osem::Source&);

} // namespace

extern "C" {
auto stream_query_roots = roots_of(static_cast<LeafAt>(&osem::leaf_at), static_cast<Measure>(&osem::measure),
                                   static_cast<Digest>(&osem::digest), static_cast<Same>(&osem::same_leaves));
}
