// OpenVDB: conversion by a signed distance field of the least width and its interior mask; Booleans of exact
// masks and of level sets. On one thread, like all others.
#include "bench/suites.hpp"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

#include "bench/agreement.hpp"
#include "bench/osem_conversion.hpp"

namespace osem::bench {

namespace {

using openvdb::BoolGrid;
using openvdb::FloatGrid;
using openvdb::MaskGrid;

void use_one_thread() {
    static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    static const bool once = (openvdb::initialize(), true);
    static_cast<void>(once);
}

// The triangles as OpenVDB asks for them: in units of cells, centres at whole numbers. That is exact.
class Adapter {
  public:
    Adapter(const BenchSolid& solid, int depth) : solid_(solid), side_(root_side >> depth) {}
    std::size_t polygonCount() const { return solid_.triangles.size(); }
    std::size_t pointCount() const { return solid_.solid.vertices.size(); }
    static std::size_t vertexCount(std::size_t) { return 3; }
    void getIndexSpacePoint(std::size_t polygon, std::size_t corner, openvdb::Vec3d& to) const {
        const Point& p = solid_.solid.vertices[solid_.triangles[polygon][corner]];
        to = (openvdb::Vec3d(p.x(), p.y(), p.z()) - side_ / 2.0) / side_;
    }

  private:
    const BenchSolid& solid_;
    double side_;
};

FloatGrid::Ptr level_set(const std::string& solid, int depth, float band, int flags = 0) {
    const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
    FloatGrid::Ptr grid = openvdb::tools::meshToVolume<FloatGrid>(Adapter(solid_of(solid), depth), *transform,
                                                                  band, band, flags);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    return grid;
}

// A tree's black leaves.
MaskGrid::Ptr mask_of(const Octree& tree) {
    MaskGrid::Ptr mask = MaskGrid::create();
    const std::int32_t cell = root_side >> tree.depth;
    LeafWalk walk(tree);
    for (Leaf leaf{}; walk.next(leaf);) {
        if (leaf.colour != Colour::black) continue;
        const Point& p = leaf.octant.corner;
        const openvdb::Coord low(p.x() / cell, p.y() / cell, p.z() / cell);
        mask->tree().fill(openvdb::CoordBBox::createCube(low, leaf.octant.side() / cell), true);
    }
    return mask;
}

MaskGrid::Ptr exact_mask(const std::string& solid, int depth) {
    return mask_of(conversion_of(solid, depth, LeafRule::centre).tree());
}

// Cells active in one of the two and not in the other.
std::uint64_t difference(const MaskGrid& a, const BoolGrid& b) {
    MaskGrid::Ptr only_a = a.deepCopy();
    only_a->topologyDifference(b);
    BoolGrid::Ptr only_b = b.deepCopy();
    only_b->topologyDifference(a);
    return only_a->activeVoxelCount() + only_b->activeVoxelCount();
}

void run_fill(benchmark::State& state, const std::string& solid, int depth) {
    use_one_thread();
    const std::uint64_t cells = agreement_on(solid, depth).cells;
    BoolGrid::Ptr mask;
    const auto convert = [&] {
        // Distances are not asked for, so nothing need be done that makes them better.
        const FloatGrid::Ptr field =
            level_set(solid, depth, 1,
                      openvdb::tools::DISABLE_RENORMALIZATION | openvdb::tools::DISABLE_NARROW_BAND_TRIMMING);
        mask = openvdb::tools::sdfInteriorMask(*field);
        return field;
    };
    FloatGrid::Ptr field = convert();
    const std::uint64_t memory = field->memUsage() + mask->memUsage();
    for (auto _ : state) {
        state.PauseTiming(); // while what was made before is freed
        field.reset();
        mask.reset();
        state.ResumeTiming();
        field = convert();
    }

    const MaskGrid::Ptr exact = exact_mask(solid, depth);
    require(exact->activeVoxelCount() == cells, "OpenVDB's mask of the octree has other cells");
    state.counters["cells"] = static_cast<double>(mask->activeVoxelCount());
    state.counters["cells_off"] = static_cast<double>(difference(*exact, *mask));
    state.counters["result_bytes"] = static_cast<double>(mask->memUsage());
    state.counters["memory_bytes"] = static_cast<double>(memory);
}

void combine(Operator op, MaskGrid& a, const MaskGrid& b) {
    switch (op) {
    case Operator::unite:
        return a.topologyUnion(b);
    case Operator::intersect:
        return a.topologyIntersection(b);
    default:
        return a.topologyDifference(b);
    }
}

// The operator changes its first operand; the copy that it is given is made while the clock stands.
void run_topology(benchmark::State& state, const Pair& pair, Operator op) {
    use_one_thread();
    const MaskGrid::Ptr a = exact_mask(pair.a, pair.depth);
    const MaskGrid::Ptr b = exact_mask(pair.b, pair.depth);
    MaskGrid::Ptr result;
    for (auto _ : state) {
        state.PauseTiming();
        result = a->deepCopy();
        state.ResumeTiming();
        combine(op, *result, *b);
    }
    require(result->activeVoxelCount() == agreed_cells(pair, op), "OpenVDB's masks differ in a Boolean");
    state.counters["result_bytes"] = static_cast<double>(result->memUsage());
    state.counters["memory_bytes"] = static_cast<double>(result->memUsage() + a->memUsage() + b->memUsage());
}

FloatGrid::Ptr csg(Operator op, const FloatGrid& a, const FloatGrid& b) {
    switch (op) {
    case Operator::unite:
        return openvdb::tools::csgUnionCopy(a, b);
    case Operator::intersect:
        return openvdb::tools::csgIntersectionCopy(a, b);
    default:
        return openvdb::tools::csgDifferenceCopy(a, b);
    }
}

void run_csg(benchmark::State& state, const Pair& pair, Operator op) {
    use_one_thread();
    const FloatGrid::Ptr a = level_set(pair.a, pair.depth, 3);
    const FloatGrid::Ptr b = level_set(pair.b, pair.depth, 3);
    FloatGrid::Ptr result;
    for (auto _ : state) {
        state.PauseTiming(); // while what was made before is freed
        result.reset();
        state.ResumeTiming();
        result = csg(op, *a, *b);
    }
    state.counters["cells"] =
        static_cast<double>(openvdb::tools::sdfInteriorMask(*result)->activeVoxelCount());
    state.counters["result_bytes"] = static_cast<double>(result->memUsage());
    state.counters["memory_bytes"] = static_cast<double>(result->memUsage() + a->memUsage() + b->memUsage());
}

} // namespace

void add_vdb_conversion(const std::string& solid, int depth) {
    const std::string name = conversion_name(solid, depth) + "vdb-fill";
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        run_fill(state, solid, depth);
    })->Unit(benchmark::kMillisecond);
}

void add_vdb_boolean(const Pair& pair, Operator op) {
    const std::string name = boolean_name(pair, op);
    benchmark::RegisterBenchmark((name + "vdb-topology").c_str(), [=](benchmark::State& state) {
        run_topology(state, pair, op);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((name + "vdb-csg").c_str(), [=](benchmark::State& state) {
        run_csg(state, pair, op);
    })->Unit(benchmark::kMillisecond);
}

} // namespace osem::bench
