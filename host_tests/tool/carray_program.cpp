// A program around headers that osem carray wrote; carray_test.cpp builds and runs it. The headers are of one
// solid, as a tree and as a solid, of a triangle mesh and of a uniform tree.
// Usage: program FILE.osem, the file of which `part::tree` was made. Exit code 0: all as it should be.
#include <cstdio>

#include "full_tree.hpp"
#include "part_solid.hpp"
#include "part_tree.hpp"
#include "part_tree.hpp" // and once more: the guard
#include "wedge_solid.hpp"

#include "osem/osem.hpp"

namespace {

static_assert(part::tree.pool == &part::pool && &part::pool.at(0) == part::nodes, "read where it lies");
static_assert(part::pool.used() == sizeof part::nodes / sizeof part::nodes[0]);
static_assert(!part::solid.is_triangle_mesh() && part::winding == osem::WindingRule::odd);
static_assert(part::solid.ring_count() + 1 == sizeof part::ring_starts / sizeof part::ring_starts[0]);
static_assert(part::solid.face_count + 1 == sizeof part::face_rings / sizeof part::face_rings[0]);
static_assert(part::solid.vertex_count == sizeof part::vertices / sizeof part::vertices[0]);
static_assert(part::solid.corner_count == sizeof part::corners / sizeof part::corners[0]);
static_assert(wedge::solid.is_triangle_mesh() && wedge::winding == osem::WindingRule::nonzero);
static_assert(full::tree.top == osem::Node::uniform(osem::Colour::black) && full::pool.used() == 0);

constexpr std::uint32_t room = 60000;
osem::StaticNodePool<room> pool;
osem::Conversion job;
osem::StreamReader reader;
osem::Edge edges[osem::check_scratch(part::solid)];
std::uint32_t faces[osem::convert_scratch(part::solid)];

bool file_has(const char* path, const osem::Octree& tree) {
    std::FILE* file = std::fopen(path, "rb");
    if (file == nullptr) return false;
    reader.begin(&pool);
    for (int byte = std::fgetc(file); byte != EOF; byte = std::fgetc(file)) {
        const auto next = static_cast<std::uint8_t>(byte);
        reader.feed(&next, 1);
    }
    std::fclose(file);
    const osem::TreeOutcome read = reader.finish().built;
    return read.status == osem::Status::ok && read.tree.depth == tree.depth &&
           osem::digest(read.tree) == osem::digest(tree) && osem::same_leaves(read.tree, tree);
}

bool accepted(const osem::Solid& solid) {
    return osem::check(solid, edges, osem::check_scratch(part::solid)).status == osem::Status::ok;
}

bool converts_to(const osem::Solid& solid, osem::WindingRule winding, const osem::Octree& tree) {
    osem::ConvertOptions options;
    options.depth = tree.depth;
    options.winding = winding;
    const osem::TreeOutcome made =
        osem::convert(job, osem::CheckedSolid::vouched(solid), options, faces, solid.face_count, &pool);
    return made.status == osem::Status::ok && osem::same_leaves(made.tree, tree);
}

bool every_leaf_is_found(const osem::Octree& tree) {
    osem::LeafWalk walk(tree);
    for (osem::Leaf leaf = {}; walk.next(leaf);) {
        const osem::Point low = leaf.octant.corner;
        const std::int32_t side = leaf.octant.side();
        const osem::CellBox box = {low, {{low.x() + side, low.y() + side, low.z() + side}}};
        if (osem::leaf_at(tree, low).leaf.colour != leaf.colour) return false;
        if (!osem::colours_in(tree, box).all(leaf.colour)) return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    if (!file_has(argv[1], part::tree)) return 2;
    if (!accepted(part::solid) || !accepted(wedge::solid)) return 3;
    if (!converts_to(part::solid, part::winding, part::tree)) return 4;
    if (!every_leaf_is_found(part::tree) || !every_leaf_is_found(full::tree)) return 5;
    return 0;
}
