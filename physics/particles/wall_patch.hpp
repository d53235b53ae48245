// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A curved triangle of a wall and the place on it below a sphere, by Newton's method, written for vector code.
#include "core/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace physics {

/// The patch is P(one, two) = corner + one edge1 + two edge2 + bends, its normal N(one, two) is linear. Everything but the
/// edges is in coordinates (one, two, height) over the flat triangle, so that Newton's method needs no square root.
struct alignas(32) WallPatch {
    static constexpr int size = 36;
    static constexpr int corner = 0, dual = 3, edges = 12, bend = 18, normal = 27; ///< Beginnings of three, nine, six, nine and nine numbers.
    std::array<double, size> value;

    /// Number n; all functions below take one patch or a row of patches(n, k), number n of the k-th.
    [[nodiscard]] double operator()(int n, int) const { return value[std::size_t(n)]; }
};

/// One place on a patch: coordinates, the unit normal there, and how far the sphere's centre is above it [m].
struct PatchFoot {
    double one, two, nx, ny, nz, depth;
};

/// Coordinates on a patch.
struct PatchPlace {
    double one, two;
};

/// Coordinates (one, two, height) of a point.
struct PatchPoint {
    double one, two, height;
};

template <class Patches>
[[gnu::always_inline]] inline PatchPoint patch_way(const Patches& patches, int k, double x, double y, double z)
{
    constexpr int d = WallPatch::dual;
    return {patches(d, k) * x + patches(d + 1, k) * y + patches(d + 2, k) * z, patches(d + 3, k) * x + patches(d + 4, k) * y + patches(d + 5, k) * z,
            patches(d + 6, k) * x + patches(d + 7, k) * y + patches(d + 8, k) * z};
}

template <class Patches>
[[gnu::always_inline]] inline PatchPoint patch_point(const Patches& patches, int k, double x, double y, double z)
{
    return patch_way(patches, k, x - patches(0, k), y - patches(1, k), z - patches(2, k));
}

/// Coordinate `axis` of the patch's bends and of its normal, with their slopes along one and two.
struct PatchSlopes {
    double bend, bend_one, bend_two, normal, normal_one, normal_two;
};

template <class Patches>
[[gnu::always_inline]] inline PatchSlopes patch_slopes(const Patches& patches, int k, int axis, double one, double two)
{
    const double zero = 1.0 - one - two;
    const double b0 = patches(WallPatch::bend + axis, k), b1 = patches(WallPatch::bend + 3 + axis, k), b2 = patches(WallPatch::bend + 6 + axis, k);
    const double n0 = patches(WallPatch::normal + axis, k), n1 = patches(WallPatch::normal + 3 + axis, k), n2 = patches(WallPatch::normal + 6 + axis, k);
    return {one * two * b0 + zero * two * b1 + zero * one * b2,
            two * (b0 - b1) + (zero - one) * b2,
            one * (b0 - b2) + (zero - two) * b1,
            zero * n0 + one * n1 + two * n2,
            n1 - n0,
            n2 - n0};
}

/// A foot far outside the triangle stays outside, wherever it ends.
[[gnu::always_inline]] inline PatchPlace bounded_place(double one, double two)
{
    return {std::max(-1.0, std::min(2.0, one)), std::max(-1.0, std::min(2.0, two))};
}

/// One Newton step towards P + depth N = centre.
template <class Patches>
[[gnu::always_inline]] inline PatchPlace improve_foot(const Patches& patches, int k, PatchPoint centre, PatchPlace from)
{
    const double one = from.one, two = from.two;
    const PatchSlopes f = patch_slopes(patches, k, 0, one, two), g = patch_slopes(patches, k, 1, one, two), h = patch_slopes(patches, k, 2, one, two);
    const double inverse = 1.0 / h.normal;
    const double depth = (centre.height - h.bend) * inverse;
    const double depth_one = -(h.bend_one + depth * h.normal_one) * inverse, depth_two = -(h.bend_two + depth * h.normal_two) * inverse;
    const double miss_one = one + f.bend + depth * f.normal - centre.one, miss_two = two + g.bend + depth * g.normal - centre.two;
    const double a = 1.0 + f.bend_one + depth_one * f.normal + depth * f.normal_one;
    const double b = f.bend_two + depth_two * f.normal + depth * f.normal_two;
    const double c = g.bend_one + depth_one * g.normal + depth * g.normal_one;
    const double d = 1.0 + g.bend_two + depth_two * g.normal + depth * g.normal_two;
    const double share = 1.0 / std::max(a * d - b * c, 0.1); // small near the centre of curvature
    return bounded_place(one - share * (d * miss_one - b * miss_two), two - share * (a * miss_two - c * miss_one));
}

/// The normal at a place and the depth of a centre over it.
template <class Patches>
[[gnu::always_inline]] inline PatchFoot patch_foot(const Patches& patches, int k, PatchPoint centre, PatchPlace place)
{
    const double one = place.one, two = place.two;
    constexpr int e = WallPatch::edges, up = WallPatch::dual + 6;
    const PatchSlopes f = patch_slopes(patches, k, 0, one, two), g = patch_slopes(patches, k, 1, one, two), h = patch_slopes(patches, k, 2, one, two);
    const double x = f.normal * patches(e, k) + g.normal * patches(e + 3, k) + h.normal * patches(up, k);
    const double y = f.normal * patches(e + 1, k) + g.normal * patches(e + 4, k) + h.normal * patches(up + 1, k);
    const double z = f.normal * patches(e + 2, k) + g.normal * patches(e + 5, k) + h.normal * patches(up + 2, k);
    const double length = std::sqrt(x * x + y * y + z * z), inverse = 1.0 / length;
    return {one, two, x * inverse, y * inverse, z * inverse, (centre.height - h.bend) / h.normal * length};
}

/// The foot of a centre. Three steps: the error is below rounding where the depth is small against the radius of curvature.
template <class Patches>
[[gnu::always_inline]] inline PatchFoot find_foot(const Patches& patches, int k, PatchPoint centre)
{
    const PatchPlace first = improve_foot(patches, k, centre, bounded_place(centre.one, centre.two));
    const PatchPlace second = improve_foot(patches, k, centre, first);
    return patch_foot(patches, k, centre, improve_foot(patches, k, centre, second));
}

} // namespace physics
