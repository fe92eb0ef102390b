#include "off_mesh.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace oracle {

namespace {

using WorldPoint = CGAL::Simple_cartesian<double>::Point_3;

// Lattice units in a world unit, and the world point that becomes the fit's lower corner.
struct Scale {
    std::array<double, 3> origin;
    double factor;
};

Scale scale_of(const std::vector<WorldPoint>& points, const Fit& fit) {
    Scale scale{};
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto order = [axis](const WorldPoint& a, const WorldPoint& b) { return a[axis] < b[axis]; };
        const auto [low, high] = std::minmax_element(points.begin(), points.end(), order);
        scale.origin[static_cast<std::size_t>(axis)] = (*low)[axis];
        extent = std::max(extent, (*high)[axis] - (*low)[axis]);
    }
    scale.factor = fit.side / extent;
    return scale;
}

osem::Point rounded(const WorldPoint& p, const Scale& scale, const Fit& fit) {
    osem::Point q = fit.low;
    for (int axis = 0; axis < 3; ++axis) {
        const double offset = p[axis] - scale.origin[static_cast<std::size_t>(axis)];
        q.at[axis] += static_cast<std::int32_t>(std::floor(offset * scale.factor + 0.5));
    }
    return q;
}

} // namespace

osem::Solid TriangleMesh::view() const {
    return osem::triangle_mesh(vertices.data(), static_cast<std::uint32_t>(vertices.size()), corners.data(),
                               static_cast<std::uint32_t>(corners.size() / 3));
}

std::string mesh_folder() {
    if (const char* folder = std::getenv("OSEM_CGAL_DATA")) return folder;
#ifdef OSEM_CGAL_DATA
    return OSEM_CGAL_DATA;
#else
    return {};
#endif
}

std::optional<TriangleMesh> read_off(const std::string& name, const Fit& fit) {
    std::vector<WorldPoint> points;
    std::vector<std::vector<std::size_t>> polygons;
    if (!CGAL::IO::read_polygon_soup(mesh_folder() + "/meshes/" + name + ".off", points, polygons) ||
        points.empty()) {
        return std::nullopt;
    }
    const Scale scale = scale_of(points, fit);
    TriangleMesh mesh;
    std::map<std::array<std::int32_t, 3>, std::uint32_t> known;
    std::vector<std::uint32_t> vertex_of;
    for (const WorldPoint& p : points) {
        const osem::Point q = rounded(p, scale, fit);
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto [entry, is_new] = known.insert({{q.x(), q.y(), q.z()}, next});
        if (is_new) mesh.vertices.push_back(q);
        vertex_of.push_back(entry->second);
    }
    for (const auto& polygon : polygons) {
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            for (const std::size_t corner : {polygon[0], polygon[i - 1], polygon[i]}) {
                mesh.corners.push_back(vertex_of[corner]);
            }
        }
    }
    return mesh;
}

} // namespace oracle
