// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/surface.hpp"
#include "core/grid/boundary_faces.hpp"
#include "core/grid/surface_seams.hpp"
#include <algorithm>
#include <numeric>

namespace core {
namespace {

struct Face {
    Quad corners;
    int name;
};

std::vector<Face> boundary_quads(const Mesh& mesh, std::span<const std::string> names)
{
    std::vector<Face> quads;
    for_each_boundary_face(mesh, names, [&](const Boundary& boundary, Quad q) {
        if (is_high(boundary.side)) std::swap(q[1], q[3]);
        quads.push_back({q, int(std::find(names.begin(), names.end(), boundary.name) - names.begin())});
    });
    return quads;
}

struct Slab {
    double low, high; ///< of the quads, along a period
};

double along(const Vec3& x, const Vec3& period) { return x.dot(period) / period.norm(); }

/// Adds the images of quads that lie within `margin` of the two ends of a period.
void continue_through(std::vector<Face>& quads, const Vec3& period, double margin)
{
    Slab slab{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const auto& [q, name] : quads)
        for (const Vec3& x : q) slab = {std::min(slab.low, along(x, period)), std::max(slab.high, along(x, period))};
    const std::size_t originals = quads.size();
    for (std::size_t n = 0; n < originals; ++n)
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 shift = sign * period;
            const auto [q, name] = quads[n];
            const bool near = std::any_of(q.begin(), q.end(), [&](const Vec3& x) {
                const double s = along(x + shift, period);
                return s > slab.low - margin && s < slab.high + margin;
            });
            if (near) quads.push_back({{q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift}, name});
        }
}

/// Gives every place one number; places closer than `tolerance` are one.
Surface welded(const std::vector<Face>& quads, double tolerance)
{
    std::vector<Vec3> corners;
    for (const auto& [q, name] : quads) corners.insert(corners.end(), q.begin(), q.end());
    std::vector<int> order(corners.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return std::pair(corners[std::size_t(a)].x(), a) < std::pair(corners[std::size_t(b)].x(), b); });
    Surface surface;
    std::vector<int> number(corners.size(), -1);
    std::size_t window = 0; // first kept vertex that may still be as near as the tolerance along x
    for (int c : order) {
        const Vec3& x = corners[std::size_t(c)];
        while (window < surface.vertices.size() && surface.vertices[window].x() < x.x() - tolerance) ++window;
        int& mine = number[std::size_t(c)];
        for (std::size_t v = window; v < surface.vertices.size() && mine < 0; ++v)
            if ((surface.vertices[v] - x).norm() < tolerance) mine = int(v);
        if (mine >= 0) continue;
        mine = int(surface.vertices.size());
        surface.vertices.push_back(x);
    }
    for (std::size_t q = 0; q < quads.size(); ++q) {
        surface.quads.push_back({number[4 * q], number[4 * q + 1], number[4 * q + 2], number[4 * q + 3]});
        surface.name.push_back(quads[q].name);
    }
    return surface;
}

} // namespace

Surface boundary_surface(const Mesh& mesh, std::span<const std::string> names, double margin)
{
    auto quads = boundary_quads(mesh, names);
    double smallest = std::numeric_limits<double>::max();
    for (const auto& [q, name] : quads)
        for (std::size_t n = 0; n < 4; ++n) smallest = std::min(smallest, (q[n] - q[(n + 1) % 4]).norm());
    for (const Vec3& period : mesh.periods()) continue_through(quads, period, margin);
    Surface surface = welded(quads, 1e-6 * smallest);
    if (!mesh.topology().joints.interfaces.empty()) close_seams(surface);
    return surface;
}

} // namespace core
