// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/line_spline.hpp"
#include <algorithm>
#include <cassert>
#include <vector>

namespace core {
namespace {

/// Solves x(i-1) + c x(i) + x(i+1) = x(i) as given, for the inner points; the ends keep their values.
void solve_line(std::span<Vec3> x, double c)
{
    const std::size_t n = x.size();
    if (n < 3) return;
    std::vector<double> upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double pivot = 1 / (c - upper[i - 1]);
        upper[i] = i + 2 < n ? pivot : 0.0;
        x[i] = pivot * (x[i] - x[i - 1] - (i + 2 < n ? Vec3(Vec3::Zero()) : x[i + 1]));
    }
    for (std::size_t i = n - 2; i > 1; --i) x[i - 1] -= upper[i - 1] * x[i];
}

/// Slope at the start of a line, seen inwards.
template <class At>
Vec3 end_slope(std::size_t n, At at)
{
    if (n >= 5) return (-25 * at(0) + 48 * at(1) - 36 * at(2) + 16 * at(3) - 3 * at(4)) / 12;
    if (n >= 3) return 0.5 * (-3 * at(0) + 4 * at(1) - at(2));
    return at(1) - at(0);
}

/// Curvature at the start of a line of five points or more.
template <class At>
Vec3 end_curvature(At at)
{
    return (35 * at(0) - 104 * at(1) + 114 * at(2) - 56 * at(3) + 11 * at(4)) / 12;
}

/// The point of the spline between two of its points, t in [0, 1].
Vec3 hermite(const Vec3& x0, const Vec3& x1, const Vec3& m0, const Vec3& m1, double t)
{
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * x0 + t * t * (1 + 2 * u) * x1 + u * u * t * m0 - t * t * u * m1;
}

} // namespace

void line_slopes(std::span<const Vec3> points, std::span<Vec3> slopes)
{
    const std::size_t n = points.size();
    assert(n >= 2 && slopes.size() == n);
    slopes[0] = end_slope(n, [&](std::size_t i) { return points[i]; });
    slopes[n - 1] = -end_slope(n, [&](std::size_t i) { return points[n - 1 - i]; });
    for (std::size_t i = 1; i + 1 < n; ++i) slopes[i] = 3 * (points[i + 1] - points[i - 1]);
    solve_line(slopes, 4);
}

void line_curvatures(std::span<const Vec3> points, Curvature kind, std::span<Vec3> curvatures)
{
    const std::size_t n = points.size();
    const auto difference = [&](std::size_t i) { return Vec3(points[i + 1] - 2 * points[i] + points[i - 1]); };
    curvatures[0] = curvatures[n - 1] = Vec3::Zero();
    if (n < 3) return;
    const bool compact = kind == Curvature::compact && n >= 5;
    const double c = compact ? 10 : 4;
    for (std::size_t i = 1; i + 1 < n; ++i) curvatures[i] = (c + 2) * difference(i);
    if (compact) {
        curvatures[0] = end_curvature([&](std::size_t i) { return points[i]; });
        curvatures[n - 1] = end_curvature([&](std::size_t i) { return points[n - 1 - i]; });
        return solve_line(curvatures, c);
    }
    // With curvatures linear over the first three points, the equation of the second gives the difference there.
    curvatures[1] = difference(1);
    curvatures[n - 2] = difference(n - 2);
    solve_line(curvatures.subspan(1, n - 2), c);
    curvatures[0] = n > 3 ? Vec3(2 * curvatures[1] - curvatures[2]) : curvatures[1];
    curvatures[n - 1] = n > 3 ? Vec3(2 * curvatures[n - 2] - curvatures[n - 3]) : curvatures[1];
}

void respace(std::span<Vec3> points, std::span<const double> shares)
{
    constexpr int parts = 32; // chords between two points
    const std::size_t n = points.size();
    const std::vector<Vec3> old(points.begin(), points.end());
    std::vector<Vec3> slopes(n);
    line_slopes(old, slopes);
    const auto at = [&](std::size_t chord) {
        const std::size_t i = std::min(chord / parts, n - 2);
        return hermite(old[i], old[i + 1], slopes[i], slopes[i + 1], double(chord - i * parts) / parts);
    };
    std::vector<double> length(parts * (n - 1) + 1, 0.0);
    for (std::size_t chord = 1; chord < length.size(); ++chord) length[chord] = length[chord - 1] + (at(chord) - at(chord - 1)).norm();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double wanted = shares[i] * length.back();
        const auto above = std::size_t(std::upper_bound(length.begin(), length.end() - 1, wanted) - length.begin());
        const double part = (wanted - length[above - 1]) / (length[above] - length[above - 1]);
        const double chords = double(above - 1) + part;
        const auto cell = std::min(std::size_t(chords / parts), n - 2);
        points[i] = hermite(old[cell], old[cell + 1], slopes[cell], slopes[cell + 1], chords / parts - double(cell));
    }
}

} // namespace core
