// CGAL: Booleans of the triangle meshes themselves by corefinement, exact predicates and constructed points.
#include "bench/suites.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include "bench/agreement.hpp"
#include "bench/solids.hpp"

namespace osem::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

// In lattice units.
Mesh mesh_of(const std::string& name) {
    const BenchSolid& solid = solid_of(name);
    Mesh mesh;
    for (const Point& p : solid.solid.vertices) mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
    for (const auto& t : solid.triangles) {
        const auto at = [](std::uint32_t vertex) { return Mesh::Vertex_index(vertex); };
        require(mesh.add_face(at(t[0]), at(t[1]), at(t[2])) != Mesh::null_face(),
                name + " is not a 2-manifold");
    }
    return mesh;
}

bool combine(Operator op, Mesh& a, Mesh& b, Mesh& result) {
    switch (op) {
    case Operator::unite:
        return processing::corefine_and_compute_union(a, b, result);
    case Operator::intersect:
        return processing::corefine_and_compute_intersection(a, b, result);
    default:
        return processing::corefine_and_compute_difference(a, b, result);
    }
}

// Corefinement changes its operands; the copies that it is given are made while the clock stands.
void run(benchmark::State& state, const Pair& pair, Operator op) {
    const Mesh a = mesh_of(pair.a);
    const Mesh b = mesh_of(pair.b);
    Mesh copy_of_a;
    Mesh copy_of_b;
    Mesh result;
    for (auto _ : state) {
        state.PauseTiming();
        copy_of_a = a;
        copy_of_b = b;
        result.clear();
        state.ResumeTiming();
        if (!combine(op, copy_of_a, copy_of_b, result)) {
            state.SkipWithError("the result is not a 2-manifold");
            break;
        }
    }
    const double cell = static_cast<double>(volume_at(pair.depth));
    state.counters["cells"] = std::round(CGAL::to_double(processing::volume(result)) / cell);
    state.counters["faces"] = static_cast<double>(result.number_of_faces());
}

} // namespace

void add_cgal_boolean(const Pair& pair, Operator op) {
    const std::string name = boolean_name(pair, op) + "cgal";
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        run(state, pair, op);
    })->Unit(benchmark::kMillisecond);
}

} // namespace osem::bench
