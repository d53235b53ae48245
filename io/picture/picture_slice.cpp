// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_slice.hpp"

#include <algorithm>
#include <cmath>

namespace io {
namespace {

using Corners = std::array<core::Vec3, 8>; // bit 0: high i, bit 1: high j, bit 2: high k

Corners corners_of(const BlockNodes& block, core::Index3 cell)
{
    Corners corners;
    for (int n = 0; n < 8; ++n) {
        const core::Index3 node{cell.i + (n & 1), cell.j + (n >> 1 & 1), cell.k + (n >> 2)};
        corners[std::size_t(n)] = Eigen::Map<const core::Vec3>(&block.points[3 * std::size_t(node_number(block.cells, node))]);
    }
    return corners;
}

/// Where the plane meets the twelve edges, in order around the polygon.
std::vector<core::Vec3> polygon(const Corners& corners, const Plane& plane, const core::Vec3& normal)
{
    std::vector<core::Vec3> points;
    for (std::size_t a = 0; a < 8; ++a)
        for (const std::size_t bit : {1, 2, 4}) {
            const std::size_t b = a | bit;
            const double from = normal.dot(corners[a] - plane.point), to = normal.dot(corners[b] - plane.point);
            if (a != b && (from < 0.0) != (to < 0.0)) points.push_back(corners[a] + from / (from - to) * (corners[b] - corners[a]));
        }
    if (points.size() < 3) return {};
    core::Vec3 centre = core::Vec3::Zero();
    for (const core::Vec3& p : points) centre += p / double(points.size());
    const core::Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
    const auto angle = [&](const core::Vec3& p) { return std::atan2(y.dot(p - centre), x.dot(p - centre)); };
    std::sort(points.begin(), points.end(), [&](const core::Vec3& p, const core::Vec3& q) { return angle(p) < angle(q); });
    return points;
}

} // namespace

std::vector<ColouredQuad> cut(const BlockNodes& block, core::View<const double> values, const Plane& plane, const ColourBar& bar)
{
    std::vector<ColouredQuad> quads;
    const core::Vec3 normal = plane.normal.normalized();
    core::for_each_cell(block.cells, [&](int i, int j, int k) {
        const auto points = polygon(corners_of(block, {i, j, k}), plane, normal);
        const auto corner = [&](std::size_t n) {
            const core::Vec3& p = points[std::min(n, points.size() - 1)];
            return std::array<float, 3>{float(p.x()), float(p.y()), float(p.z())};
        };
        const Colour colour = sequential_colour((values(i, j, k) - bar.low) / (bar.high - bar.low));
        for (std::size_t n = 1; n + 1 < points.size(); n += 2)
            quads.push_back({{corner(0), corner(n), corner(n + 1), corner(n + 2)}, colour});
    });
    return quads;
}

} // namespace io
