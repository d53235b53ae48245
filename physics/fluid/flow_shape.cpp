// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/flow_shape.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/side_tiling.hpp"
#include "physics/fluid/side_faces.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <memory>

namespace physics {
namespace {

using core::Vec3;

struct Segment {
    Vec3 from, to;
};

double distance(const Segment& s, const Vec3& x)
{
    const Vec3 along = s.to - s.from;
    const double share = std::clamp((x - s.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (x - s.from - share * along).norm();
}

double distance(const std::vector<Segment>& segments, const Vec3& x)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& s : segments) least = std::min(least, distance(s, x));
    return least;
}

/// The side of a block at the low or high end of one of the tangential axes of a side, and its edges along the other.
void add_edges(const core::Vertices& vertices, core::Side side, core::Side beside, std::vector<Segment>& edges)
{
    const int axis = core::axis_of(side), across = core::axis_of(beside), along = 3 - axis - across;
    const core::Extents cells = core::cells_of(vertices);
    core::Index3 at;
    at[axis] = core::is_high(side) ? cells[axis] : 0;
    at[across] = core::is_high(beside) ? cells[across] : 0;
    for (at[along] = 0; at[along] < cells[along]; ++at[along]) {
        core::Index3 next = at;
        ++next[along];
        edges.push_back({vertices(at.i, at.j, at.k), vertices(next.i, next.j, next.k)});
    }
}

std::vector<Segment> wall_edges(const core::Mesh& mesh, const std::string& boundary, const std::function<bool(const std::string&)>& is_wall)
{
    const auto& all = mesh.topology().boundaries;
    std::vector<Segment> edges;
    for (const core::Boundary& open : all)
        for (const core::Boundary& other : all)
            if (open.name == boundary && other.block == open.block && core::axis_of(other.side) != core::axis_of(open.side) &&
                is_wall(other.name))
                add_edges(mesh.vertices(open.block), open.side, other.side, edges);
    return edges;
}

/// Calls body(shape, corners) for all faces of a boundary, on whatever rank.
template <class Body>
void for_each_face(const core::Mesh& mesh, const std::string& boundary, Body body)
{
    for (const core::Boundary& open : mesh.topology().boundaries)
        if (open.name == boundary)
            for_each_side_face(mesh.cells(open.block), open.side, [&](int i, int j, int k) {
                const core::Quad corners = core::face_corners(mesh.vertices(open.block), core::axis_of(open.side), {i, j, k});
                body(core::face_shape(corners), corners);
            });
}

/// Weighted least squares of a linear function; the smallest gradient where places do not decide it, as across a surface.
Vec3 fitted(const std::vector<VelocityPoint>& points, std::span<const std::size_t> nearest, const Vec3& x)
{
    Eigen::Matrix<double, Eigen::Dynamic, 4> places(nearest.size(), 4);
    Eigen::Matrix<double, Eigen::Dynamic, 3> velocities(nearest.size(), 3);
    const double reach = (points[nearest.back()].place - x).norm();
    for (std::size_t n = 0; n < nearest.size(); ++n) {
        const Vec3 offset = (points[nearest[n]].place - x) / reach;
        if (offset.norm() < 1e-9) return points[nearest[n]].velocity;
        const double weight = 1 / offset.norm();
        places.row(Eigen::Index(n)) << weight, weight * offset.transpose();
        velocities.row(Eigen::Index(n)) = weight * points[nearest[n]].velocity.transpose();
    }
    const Eigen::Matrix<double, 4, 3> fit = places.completeOrthogonalDecomposition().solve(velocities);
    return fit.row(0).transpose();
}

} // namespace

std::function<double(const Vec3&)> laminar_shape(const core::Mesh& mesh, const std::string& boundary,
                                                 const std::function<bool(const std::string&)>& is_wall)
{
    const auto edges = wall_edges(mesh, boundary, is_wall);
    core::require<core::ConfigError>(!edges.empty(), core::text("no wall meets the boundary '", boundary, "': laminar flow needs one"));
    double largest = 0;
    for_each_face(mesh, boundary, [&](const core::FaceShape& shape, const core::Quad& corners) {
        largest = std::max(largest, distance(edges, shape.centre));
        for (const Vec3& corner : corners) largest = std::max(largest, distance(edges, corner));
    });
    const auto shape_at = [edges, largest](const Vec3& x) {
        const double inner = 1 - distance(edges, x) / largest;
        return 1 - inner * inner;
    };
    double area = 0, sum = 0;
    for_each_face(mesh, boundary, [&](const core::FaceShape& shape, const core::Quad&) {
        area += shape.area.norm();
        sum += shape.area.norm() * shape_at(shape.centre);
    });
    return [shape_at, scale = area / sum](const Vec3& x) { return scale * shape_at(x); };
}

std::function<Vec3(const Vec3&)> interpolated_velocity(std::vector<VelocityPoint> points)
{
    core::require<core::ConfigError>(!points.empty(), "a velocity between points needs points");
    return [points = std::move(points)](const Vec3& x) -> Vec3 {
        constexpr std::size_t most = 8;
        std::vector<std::size_t> order(points.size());
        for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
        const std::size_t count = std::min(most, order.size());
        // Of points equally far away the first ones count, on every rank.
        std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(), [&](std::size_t a, std::size_t b) {
            const double da = (points[a].place - x).squaredNorm(), db = (points[b].place - x).squaredNorm();
            return da < db || (da == db && a < b);
        });
        if (count == 1) return points[order.front()].velocity;
        return fitted(points, std::span(order).first(count), x);
    };
}

} // namespace physics
