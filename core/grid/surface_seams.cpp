// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/surface_seams.hpp"
#include <algorithm>
#include <map>

namespace core {
namespace {

using QuadCorners = std::array<int, 4>;

/// The edges of a surface that one quadrilateral alone has, and the vertices at their ends.
class OpenEdges {
public:
    explicit OpenEdges(const Surface& surface)
    {
        for (const QuadCorners& quad : surface.quads)
            for (std::size_t k = 0; k < 4; ++k) ++count_[key(quad, k)];
        for (const auto& [edge, count] : count_)
            if (count == 1 && edge.first != edge.second)
                for (const int v : {edge.first, edge.second}) ends_.emplace_back(surface.vertices[std::size_t(v)], v);
        std::sort(ends_.begin(), ends_.end(),
                  [](const End& a, const End& b) { return std::pair(a.first.x(), a.second) < std::pair(b.first.x(), b.second); });
    }
    [[nodiscard]] bool has(const QuadCorners& quad, std::size_t k) const
    {
        return quad[k] != quad[(k + 1) % 4] && count_.at(key(quad, k)) == 1;
    }
    /// Vertices between two places, in the order of the way.
    [[nodiscard]] std::vector<int> between(const Vec3& from, const Vec3& to) const
    {
        constexpr double rounding = 1e-6;
        const Vec3 edge = to - from;
        const double reach = rounding * edge.norm(), low = std::min(from.x(), to.x()) - reach, high = std::max(from.x(), to.x()) + reach;
        std::vector<std::pair<double, int>> found;
        auto end = std::lower_bound(ends_.begin(), ends_.end(), low, [](const End& a, double x) { return a.first.x() < x; });
        for (; end != ends_.end() && end->first.x() <= high; ++end) {
            const double share = (end->first - from).dot(edge) / edge.squaredNorm();
            const bool inside = share > rounding && share < 1 - rounding;
            if (inside && (end->first - (from + share * edge)).norm() < reach) found.emplace_back(share, end->second);
        }
        std::sort(found.begin(), found.end());
        std::vector<int> numbers;
        for (const auto& [share, number] : found)
            if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
        return numbers;
    }

private:
    using End = std::pair<Vec3, int>;
    static std::pair<int, int> key(const QuadCorners& quad, std::size_t k)
    {
        return {std::min(quad[k], quad[(k + 1) % 4]), std::max(quad[k], quad[(k + 1) % 4])};
    }
    std::map<std::pair<int, int>, int> count_;
    std::vector<End> ends_;
};

/// A face with all vertices on its rim, and the edges that gained some.
struct Rim {
    std::vector<int> vertices;
    std::vector<std::size_t> edges;
};

Rim rim_of(const Surface& surface, const QuadCorners& quad, const OpenEdges& open)
{
    Rim rim;
    for (std::size_t k = 0; k < 4; ++k) {
        rim.vertices.push_back(quad[k]);
        if (!open.has(quad, k)) continue;
        const auto gained = open.between(surface.vertices[std::size_t(quad[k])], surface.vertices[std::size_t(quad[(k + 1) % 4])]);
        rim.vertices.insert(rim.vertices.end(), gained.begin(), gained.end());
        if (!gained.empty()) rim.edges.push_back(k);
    }
    return rim;
}

/// From where a face is cut into triangles: the corner across from the only edge that gained vertices, or a new vertex in its middle.
int apex_of(Surface& surface, const QuadCorners& quad, const Rim& rim)
{
    if (rim.edges.size() == 1) return quad[(rim.edges.front() + 2) % 4];
    Vec3 middle = Vec3::Zero();
    for (const int v : quad) middle += 0.25 * surface.vertices[std::size_t(v)];
    surface.vertices.push_back(middle);
    return int(surface.vertices.size()) - 1;
}

} // namespace

void close_seams(Surface& surface)
{
    const OpenEdges open(surface);
    std::vector<QuadCorners> quads;
    std::vector<int> names;
    for (std::size_t q = 0; q < surface.quads.size(); ++q) {
        const QuadCorners quad = surface.quads[q];
        const Rim rim = rim_of(surface, quad, open);
        const auto add = [&](const QuadCorners& part) {
            quads.push_back(part);
            names.push_back(surface.name[q]);
        };
        if (rim.edges.empty()) {
            add(quad);
            continue;
        }
        const int apex = apex_of(surface, quad, rim);
        for (std::size_t n = 0; n < rim.vertices.size(); ++n) {
            const int from = rim.vertices[n], to = rim.vertices[(n + 1) % rim.vertices.size()];
            if (from != apex && to != apex && from != to) add({apex, from, to, to});
        }
    }
    surface.quads = std::move(quads);
    surface.name = std::move(names);
}

} // namespace core
