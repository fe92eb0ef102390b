#include "osem/osem.hpp"

// A wedge on the lattice: five planar faces. All of it could lie in flash.
constexpr osem::Point vertices[] = {{{100000, 100000, 100000}}, {{900000, 100000, 100000}},
                                    {{900000, 900000, 100000}}, {{100000, 900000, 100000}},
                                    {{100000, 100000, 600000}}, {{100000, 900000, 600000}}};
constexpr std::uint32_t corners[] = {0, 3, 2, 1, 0, 1, 4, 1, 2, 5, 4, 2, 3, 5, 0, 4, 5, 3};
constexpr std::uint32_t ring_starts[] = {0, 4, 7, 11, 14, 18};
constexpr std::uint32_t face_rings[] = {0, 1, 2, 3, 4, 5};
constexpr osem::Solid wedge = {vertices, 6, corners, 18, ring_starts, face_rings, 5};

osem::StaticNodePool<4000> pool; // all the memory there is, known before the start
osem::Conversion conversion;
osem::Edge edges[osem::check_scratch(wedge)];
std::uint32_t faces[osem::convert_scratch(wedge)];

int main() {
    const osem::CheckOutcome checked = osem::check(wedge, edges, osem::check_scratch(wedge));
    if (checked.status != osem::Status::ok) return 1; // refused, and checked says where

    osem::ConvertOptions options;
    options.depth = 6; // leaves of 1/64 of the root's side
    const osem::TreeOutcome zone =
        osem::convert(conversion, checked.solid, options, faces, osem::convert_scratch(wedge), &pool);
    if (zone.status != osem::Status::ok) return 2; // zone.nodes_missing says how many more nodes it takes

    const osem::PointOutcome at = osem::leaf_at(zone.tree, osem::Point{{200000, 500000, 200000}});
    return at.leaf.colour == osem::Colour::black ? 0 : 3; // certainly inside
}
