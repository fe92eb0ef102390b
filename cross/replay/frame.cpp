// From the world to the lattice and back.
#include "osem/frame.hpp"

#include "topics.hpp"

namespace osem::cross {

namespace {

WorldPoint read_world(Reader& reader) {
    const Point p = reader.point();
    return WorldPoint{{p.at[0], p.at[1], p.at[2]}};
}

void compare(Report& report, const char* what, const std::int32_t (&expected)[3],
             const std::int32_t (&found)[3]) {
    for (int axis = 0; axis < 3; ++axis) report.expect(what, expected[axis], found[axis]);
}

} // namespace

bool replay_frame(Reader& reader, Arena&, Report& report) {
    Frame frame = {};
    for (std::int32_t& coordinate : frame.origin) coordinate = reader.i32();
    frame.shift = static_cast<std::int8_t>(reader.u8());
    for (std::uint32_t left = reader.cases(); left > 0; --left) {
        report.begin_case();
        const WorldPoint world = read_world(reader);
        const int to_lattice_status = reader.u8();
        const Point mapped = reader.point();
        Point lattice = {};
        report.expect("status of to_lattice", to_lattice_status,
                      static_cast<int>(to_lattice(frame, &world, 1, &lattice).status));
        compare(report, "to_lattice", mapped.at, lattice.at);

        const Point back = reader.point();
        const int to_world_status = reader.u8();
        const WorldPoint mapped_back = read_world(reader);
        WorldPoint found = {};
        report.expect("status of to_world", to_world_status, static_cast<int>(to_world(frame, back, found)));
        compare(report, "to_world", mapped_back.at, found.at);
    }
    return true;
}

} // namespace osem::cross
