// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/elliptic.hpp"
#include "core/base/error.hpp"
#include "core/grid/elliptic_system.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/wall_layers.hpp"
#include <algorithm>
#include <limits>

namespace core {
namespace {

/// Half of the move for splines: their curvature is up to three times the second difference of the left side, that of the
/// compact form up to one and a half times.
double relaxation_of(Curvature kind) { return kind == Curvature::cubic_spline ? 0.5 : 0.8; }

/// The folded cell with the smallest Jacobian, if there is one.
std::optional<Index3> folded_cell(const Vertices& block)
{
    constexpr double smallest_allowed = 1e-6; // of the product of the edges
    std::optional<Index3> worst;
    double smallest = smallest_allowed;
    for_each_cell(cells_of(block), [&](int i, int j, int k) {
        const double jacobian = smallest_corner_jacobian(block, {i, j, k});
        if (jacobian >= smallest) return;
        smallest = jacobian;
        worst = Index3{i, j, k};
    });
    return worst;
}

ControlFunctions asked_control(const Vertices& block, const Elliptic& wanted, double share)
{
    ControlFunctions control = no_control(block.extents());
    for (const Attraction& a : wanted.attractions) add_attraction({a.at, share * a.strength, a.reach}, control);
    for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t n = 0; n < control.source[m].data().size(); ++n) {
            if (!wanted.control.source[m].data().empty()) control.source[m].data()[n] += share * wanted.control.source[m].data()[n];
            if (!wanted.control.factor[m].data().empty()) control.factor[m].data()[n] += share * wanted.control.factor[m].data()[n];
        }
    return control;
}

/// A block of three layers that are one plane section, far apart.
struct Extrusion {
    int axis;
    Vec3 step; ///< from one layer to the next
};

void extrude(Vertices& block, const Extrusion& section)
{
    Index3 low, high{block.extents().ni, block.extents().nj, block.extents().nk};
    low[section.axis] = 1;
    high[section.axis] = 2;
    for_each(low, high, [&](int i, int j, int k) {
        Index3 below{i, j, k}, above{i, j, k};
        --below[section.axis];
        ++above[section.axis];
        block.view()[below] = block(i, j, k) - section.step;
        block.view()[above] = block(i, j, k) + section.step;
    });
}

/// Mean edge of a block, or of its section [m].
double mean_edge(const Vertices& block, const std::optional<Extrusion>& section)
{
    double sum = 0, count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (section && section->axis == axis) continue;
        Index3 high{block.extents().ni, block.extents().nj, block.extents().nk};
        high[axis] -= 1;
        for_each({0, 0, 0}, high, [&](int i, int j, int k) {
            Index3 next{i, j, k};
            ++next[axis];
            sum += (block.view()[next] - block(i, j, k)).norm();
            ++count;
        });
    }
    return sum / count;
}

/// Iterates from the vertices given until they rest.
EllipticResult relax(Vertices& block, const Elliptic& wanted, double share, const std::optional<Extrusion>& section)
{
    constexpr double spacing_tolerance = 0.01;
    const ControlFunctions asked = asked_control(block, wanted, share);
    WallLayers layers(block, wanted.spacings, wanted.curvature);
    EllipticSystem system(block.extents(), wanted.curvature);
    const double edge = mean_edge(block, section);
    EllipticResult result;
    result.control_share = share;
    for (result.iterations = 1; result.iterations <= wanted.most_iterations; ++result.iterations) {
        ControlFunctions control = asked;
        layers.add_factors(share, control);
        result.move = system.advance(block, control, relaxation_of(wanted.curvature)) / edge;
        if (section) extrude(block, *section);
        result.spacing_error = layers.correct(block);
        if (!std::isfinite(result.move)) break;
        if (result.move < wanted.tolerance && (result.spacing_error < spacing_tolerance || share < 1)) break;
    }
    return result;
}

EllipticResult generate(Vertices& block, const Elliptic& wanted, const std::optional<Extrusion>& section)
{
    const Vertices start = block;
    for (const double share : {1.0, 0.5, 0.25, 0.0}) {
        block = start;
        const EllipticResult result = relax(block, wanted, share, section);
        if (std::isfinite(result.move) && !folded_cell(block)) return result;
    }
    const auto c = folded_cell(block).value_or(Index3{});
    throw ConfigError(text("the elliptic grid has a folded cell (", c.i, ", ", c.j, ", ", c.k,
                           ") even without control functions: cut the block, or move points of its sides apart"));
}

/// The normal of a side, by its area.
/// @throws ConfigError unless all its vertices lie in one plane.
Vec3 plane_normal(const Vertices& block, Side side, Index3 low, Index3 high)
{
    constexpr double flat = 1e-6; // of the size of the side
    Vec3 area = Vec3::Zero();
    Index3 last{high.i - 1, high.j - 1, high.k - 1};
    const int p = (axis_of(side) + 1) % 3, q = (axis_of(side) + 2) % 3;
    const Vec3 origin = block.view()[low];
    double size = 0;
    const auto along_rim = [&](Index3 from, int axis, int by) {
        for (Index3 c = from; c[axis] + by >= low[axis] && c[axis] + by <= last[axis]; c[axis] += by) {
            Index3 next = c;
            next[axis] += by;
            area += 0.5 * (block.view()[c] - origin).cross(block.view()[next] - origin);
            size = std::max(size, (block.view()[next] - origin).norm());
        }
    };
    Index3 second = low, fourth = low;
    second[p] = last[p];
    fourth[q] = last[q];
    along_rim(low, p, 1);
    along_rim(second, q, 1);
    along_rim(last, p, -1);
    along_rim(fourth, q, -1);
    const Vec3 normal = area.normalized();
    for_each(low, high, [&](int i, int j, int k) {
        const bool rim =
            Index3{i, j, k}[p] == low[p] || Index3{i, j, k}[p] == last[p] || Index3{i, j, k}[q] == low[q] || Index3{i, j, k}[q] == last[q];
        require<ConfigError>(!rim || std::abs(normal.dot(block(i, j, k) - origin)) < flat * size,
                             text("side ", side_words[std::size_t(side)], " is not plane: give its vertices"));
    });
    return normal;
}

/// What concerns the side, in the counting of a block of three layers.
Elliptic on_side(const Elliptic& wanted, int axis)
{
    Elliptic inside = wanted;
    inside.control = {};
    std::erase_if(inside.spacings, [&](const WallSpacing& wall) { return axis_of(wall.side) == axis; });
    for (Attraction& a : inside.attractions) a.at[std::size_t(axis)].reset();
    return inside;
}

} // namespace

EllipticResult solve_elliptic(Vertices& block, const Elliptic& wanted) { return generate(block, wanted, std::nullopt); }

EllipticResult make_elliptic(Vertices& block, const Elliptic& wanted)
{
    respace_lines(block, wanted.spacings);
    return solve_elliptic(block, wanted);
}

EllipticResult make_elliptic_side(Vertices& block, Side side, const Elliptic& wanted)
{
    constexpr double far = 1e4; // edges between the layers: their share of the metrics falls with the square
    const int axis = axis_of(side);
    Index3 low, high{block.extents().ni, block.extents().nj, block.extents().nk};
    low[axis] = is_high(side) ? high[axis] - 1 : 0;
    high[axis] = low[axis] + 1;
    Extents layers = block.extents();
    (axis == 0 ? layers.ni : axis == 1 ? layers.nj : layers.nk) = 3;
    Vertices section(layers, 0, Vec3::Zero());
    const Extrusion extrusion{axis, far * mean_edge(block, std::nullopt) * plane_normal(block, side, low, high)};
    const auto middle = [&](Index3 c) {
        c[axis] = 1;
        return c;
    };
    for_each(low, high, [&](int i, int j, int k) { section.view()[middle({i, j, k})] = block(i, j, k); });
    extrude(section, extrusion);
    const Elliptic inside = on_side(wanted, axis);
    respace_lines(section, inside.spacings);
    const EllipticResult result = generate(section, inside, extrusion);
    for_each(low, high, [&](int i, int j, int k) { block(i, j, k) = section.view()[middle({i, j, k})]; });
    return result;
}

} // namespace core
