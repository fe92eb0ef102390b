// One function a topic: replays the current record. False when the record does not fit the arena; nothing of
// it has been counted then.
#ifndef OSEM_CROSS_REPLAY_TOPICS_HPP
#define OSEM_CROSS_REPLAY_TOPICS_HPP

#include "arena.hpp"
#include "reader.hpp"
#include "report.hpp"

namespace osem::cross {

bool replay_orientation(Reader& reader, Arena& arena, Report& report);
bool replay_plane(Reader& reader, Arena& arena, Report& report);
bool replay_classify(Reader& reader, Arena& arena, Report& report);
bool replay_crossing(Reader& reader, Arena& arena, Report& report);
bool replay_frame(Reader& reader, Arena& arena, Report& report);
bool replay_conversion(Reader& reader, Arena& arena, Report& report);
bool replay_boolean(Reader& reader, Arena& arena, Report& report);
bool replay_measure(Reader& reader, Arena& arena, Report& report);
bool replay_query(Reader& reader, Arena& arena, Report& report);
bool replay_csg(Reader& reader, Arena& arena, Report& report);
bool replay_transform(Reader& reader, Arena& arena, Report& report);
bool replay_slice(Reader& reader, Arena& arena, Report& report);
bool replay_stream(Reader& reader, Arena& arena, Report& report);
bool replay_surface(Reader& reader, Arena& arena, Report& report);
bool replay_fit(Reader& reader, Arena& arena, Report& report);

} // namespace osem::cross

#endif
