// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/triangle_mesh.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace physics {
namespace {

using core::ConfigError, core::require, core::text, core::Vec3;
using Corners = std::array<Vec3, 3>;

constexpr double same_place = 1e-6; ///< Over the extent of the surface.
constexpr double flat = 1e-6;       ///< Height over longest edge of a triangle without area.

double extent_of(std::span<const Corners> triangles)
{
    Vec3 low = triangles.front()[0], high = low;
    for (const Corners& corners : triangles)
        for (const Vec3& x : corners) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    return (high - low).norm();
}

/// Numbers places; those nearer to each other than a tolerance have the same number.
class Places {
public:
    explicit Places(double tolerance) : tolerance_(tolerance) {}

    [[nodiscard]] int number_of(const Vec3& x)
    {
        const auto home = bin(x);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k)
                    if (const auto found = bins_.find({home[0] + i, home[1] + j, home[2] + k}); found != bins_.end())
                        for (const int n : found->second)
                            if ((places[std::size_t(n)] - x).norm() <= tolerance_) return n;
        places.push_back(x);
        bins_[home].push_back(int(places.size()) - 1);
        return int(places.size()) - 1;
    }

    std::vector<Vec3> places;

private:
    using Bin = std::array<std::int64_t, 3>;
    [[nodiscard]] Bin bin(const Vec3& x) const
    {
        Bin b;
        for (std::size_t a = 0; a < 3; ++a) b[a] = std::int64_t(std::floor(x[int(a)] / (2 * tolerance_)));
        return b;
    }
    double tolerance_;
    std::map<Bin, std::vector<int>> bins_;
};

void require_area(const TriangleMesh& mesh, int t)
{
    const auto [a, b, c] = mesh.triangles[std::size_t(t)];
    const auto corner = [&](int n) { return mesh.vertices[std::size_t(n)]; };
    const double longest = std::max({(corner(b) - corner(a)).norm(), (corner(c) - corner(b)).norm(), (corner(a) - corner(c)).norm()});
    const double twice_area = (corner(b) - corner(a)).cross(corner(c) - corner(a)).norm();
    require<ConfigError>(a != b && b != c && c != a && twice_area > flat * longest * longest,
                         text("triangle ", t + 1, " of ", mesh.triangles.size(), " at (", corner(a).transpose(),
                              ") m has no area: remove it, or join the corners around it"));
}

/// The triangles at each edge, lower vertex first.
using Edges = std::map<std::pair<int, int>, std::vector<int>>;

Edges edges_of(const TriangleMesh& mesh)
{
    Edges edges;
    for (int t = 0; t < int(mesh.triangles.size()); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = mesh.triangles[std::size_t(t)][k], b = mesh.triangles[std::size_t(t)][(k + 1) % 3];
            auto& here = edges[{std::min(a, b), std::max(a, b)}];
            here.push_back(t);
            require<ConfigError>(here.size() <= 2,
                                 text("triangles ", here[0] + 1, ", ", here[1] + 1, " and ", t + 1, " share the edge at (",
                                      mesh.vertices[std::size_t(a)].transpose(),
                                      ") m: a surface has at most two triangles at an edge; give its parts as walls of their own"));
        }
    return edges;
}

bool runs_from(const std::array<int, 3>& triangle, int a, int b)
{
    for (std::size_t k = 0; k < 3; ++k)
        if (triangle[k] == a && triangle[(k + 1) % 3] == b) return true;
    return false;
}

/// From each triangle that is not yet turned, through all that hang together with it.
void turn_to_neighbours(TriangleMesh& mesh, const Edges& edges)
{
    std::vector<char> turned(mesh.triangles.size(), 0);
    std::vector<int> front;
    for (int first = 0; first < int(mesh.triangles.size()); ++first) {
        if (turned[std::size_t(first)]) continue;
        turned[std::size_t(first)] = 1;
        front.assign(1, first);
        while (!front.empty()) {
            const int t = front.back();
            front.pop_back();
            const auto triangle = mesh.triangles[std::size_t(t)];
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = triangle[k], b = triangle[(k + 1) % 3];
                for (const int other : edges.at({std::min(a, b), std::max(a, b)})) {
                    if (other == t) continue;
                    auto& next = mesh.triangles[std::size_t(other)];
                    const bool agrees = runs_from(next, b, a);
                    require<ConfigError>(agrees || !turned[std::size_t(other)],
                                         text("triangles ", t + 1, " and ", other + 1, " join the two sides of the surface into one"));
                    if (turned[std::size_t(other)]) continue;
                    if (!agrees) std::swap(next[1], next[2]);
                    turned[std::size_t(other)] = 1;
                    front.push_back(other);
                }
            }
        }
    }
}

} // namespace

TriangleMesh joined_triangles(std::span<const Corners> triangles)
{
    require<ConfigError>(!triangles.empty(), "a surface needs triangles");
    TriangleMesh mesh;
    Places places(same_place * extent_of(triangles));
    for (const Corners& corners : triangles)
        mesh.triangles.push_back({places.number_of(corners[0]), places.number_of(corners[1]), places.number_of(corners[2])});
    mesh.vertices = std::move(places.places);
    for (int t = 0; t < int(mesh.triangles.size()); ++t) require_area(mesh, t);
    turn_to_neighbours(mesh, edges_of(mesh));
    return mesh;
}

std::optional<core::Vec3> rim_of(const TriangleMesh& mesh)
{
    for (const auto& [edge, triangles] : edges_of(mesh))
        if (triangles.size() == 1) return mesh.vertices[std::size_t(edge.first)];
    return std::nullopt;
}

} // namespace physics
