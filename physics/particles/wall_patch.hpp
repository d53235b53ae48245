// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A curved triangle of a wall and the place on it below a sphere, by Newton's method; Real is a double or core::Four.
#include "core/base/four.hpp"
#include "core/base/vec3.hpp"

#include <array>

namespace physics {

/// The patch is P(one, two) = corner + one edge1 + two edge2 + bends, with the bends one (1 - one) bend1 + two (1 - two) bend2 +
/// one two twist; its normal N(one, two) is linear. Everything but the edges is in coordinates (one, two, height) over the
/// flat triangle, so that Newton's method needs no square root.
struct alignas(32) WallPatch {
    static constexpr int size = 36;
    static constexpr int corner = 0, dual = 3, edges = 12, bend = 18,
                         normal = 27; ///< Beginnings of three, nine, six, nine and nine numbers.
    std::array<double, size> value;

    [[nodiscard]] double operator[](int n) const { return value[std::size_t(n)]; }
};

/// Four patches side by side. All functions below take these or one patch.
struct FourPatches {
    std::array<core::Four, WallPatch::size> value;

    /// The patches of four triangles.
    [[gnu::always_inline]] void read(const WallPatch* patches, const std::array<int, 4>& triangle)
    {
        for (std::size_t n = 0; n < value.size(); n += 4) {
            for (std::size_t lane = 0; lane < 4; ++lane) value[n + lane] = core::load_four(patches[triangle[lane]].value.data() + n);
            core::transpose(value[n], value[n + 1], value[n + 2], value[n + 3]);
        }
    }
    [[nodiscard]] const core::Four& operator[](int n) const { return value[std::size_t(n)]; }
};

/// One place on a patch: coordinates, the unit normal there, and how far the sphere's centre is above it [m].
template <class Real>
struct PatchFoot {
    Real one, two, nx, ny, nz, depth;
};

/// Coordinates on a patch.
template <class Real>
struct PatchPlace {
    Real one, two;
};

/// Coordinates (one, two, height) of a point.
template <class Real>
struct PatchPoint {
    Real one, two, height;
};

template <class Patches, class Real>
[[gnu::always_inline]] inline PatchPoint<Real> patch_way(const Patches& patch, const Real& x, const Real& y, const Real& z)
{
    constexpr int d = WallPatch::dual;
    return {patch[d] * x + patch[d + 1] * y + patch[d + 2] * z, patch[d + 3] * x + patch[d + 4] * y + patch[d + 5] * z,
            patch[d + 6] * x + patch[d + 7] * y + patch[d + 8] * z};
}

template <class Patches, class Real>
[[gnu::always_inline]] inline PatchPoint<Real> patch_point(const Patches& patch, const Real& x, const Real& y, const Real& z)
{
    return patch_way(patch, Real(x - patch[0]), Real(y - patch[1]), Real(z - patch[2]));
}

/// Polynomials of a place, in which the patch is linear.
template <class Real>
struct PatchShapes {
    Real one, two, bulge_one, bulge_two, product, rise_one, rise_two;
    [[gnu::always_inline]] explicit PatchShapes(const PatchPlace<Real>& at)
        : one(at.one),
          two(at.two),
          bulge_one(one - one * one),
          bulge_two(two - two * two),
          product(one * two),
          rise_one(1.0 - one - one),
          rise_two(1.0 - two - two)
    {
    }
};

/// Coordinate `axis` of the patch's bends and of its normal, with their slopes along one and two.
template <class Real>
struct PatchSlopes {
    Real bend, bend_one, bend_two, normal, normal_one, normal_two;
};

template <class Patches, class Real>
[[gnu::always_inline]] inline PatchSlopes<Real> patch_slopes(const Patches& patch, int axis, const PatchShapes<Real>& at)
{
    const int b = WallPatch::bend + axis, n = WallPatch::normal + axis;
    const Real bend1 = patch[b], bend2 = patch[b + 3], twist = patch[b + 6], normal1 = patch[n + 3], normal2 = patch[n + 6];
    return {at.bulge_one * bend1 + at.bulge_two * bend2 + at.product * twist,
            at.rise_one * bend1 + at.two * twist,
            at.rise_two * bend2 + at.one * twist,
            patch[n] + at.one * normal1 + at.two * normal2,
            normal1,
            normal2};
}

/// A foot far outside the triangle stays outside, wherever it ends.
template <class Real>
[[gnu::always_inline]] inline PatchPlace<Real> bounded_place(const Real& one, const Real& two)
{
    const Real low = Real{} - 1.0, high = Real{} + 2.0;
    return {core::greater(low, core::lesser(high, one)), core::greater(low, core::lesser(high, two))};
}

/// One Newton step towards P + depth N = centre.
template <class Patches, class Real>
[[gnu::always_inline]] inline PatchPlace<Real> improve_foot(const Patches& patch, const PatchPoint<Real>& centre,
                                                            const PatchPlace<Real>& from)
{
    const Real one = from.one, two = from.two;
    const PatchShapes<Real> at(from);
    const auto f = patch_slopes(patch, 0, at), g = patch_slopes(patch, 1, at), h = patch_slopes(patch, 2, at);
    const Real inverse = 1.0 / h.normal;
    const Real depth = (centre.height - h.bend) * inverse;
    const Real depth_one = -(h.bend_one + depth * h.normal_one) * inverse, depth_two = -(h.bend_two + depth * h.normal_two) * inverse;
    const Real miss_one = one + f.bend + depth * f.normal - centre.one, miss_two = two + g.bend + depth * g.normal - centre.two;
    const Real a = 1.0 + f.bend_one + depth_one * f.normal + depth * f.normal_one;
    const Real b = f.bend_two + depth_two * f.normal + depth * f.normal_two;
    const Real c = g.bend_one + depth_one * g.normal + depth * g.normal_one;
    const Real d = 1.0 + g.bend_two + depth_two * g.normal + depth * g.normal_two;
    const Real least = Real{} + 0.1; // the determinant is small near the centre of curvature
    const Real share = 1.0 / core::greater(a * d - b * c, least);
    return bounded_place<Real>(one - share * (d * miss_one - b * miss_two), two - share * (a * miss_two - c * miss_one));
}

/// The normal at a place and the depth of a centre over it.
template <class Patches, class Real>
[[gnu::always_inline]] inline PatchFoot<Real> patch_foot(const Patches& patch, const PatchPoint<Real>& centre,
                                                         const PatchPlace<Real>& place)
{
    constexpr int e = WallPatch::edges, up = WallPatch::dual + 6;
    const PatchShapes<Real> at(place);
    const auto f = patch_slopes(patch, 0, at), g = patch_slopes(patch, 1, at), h = patch_slopes(patch, 2, at);
    const Real x = f.normal * patch[e] + g.normal * patch[e + 3] + h.normal * patch[up];
    const Real y = f.normal * patch[e + 1] + g.normal * patch[e + 4] + h.normal * patch[up + 1];
    const Real z = f.normal * patch[e + 2] + g.normal * patch[e + 5] + h.normal * patch[up + 2];
    const Real length = core::square_root(x * x + y * y + z * z), inverse = 1.0 / length;
    return {place.one, place.two, x * inverse, y * inverse, z * inverse, (centre.height - h.bend) / h.normal * length};
}

/// The foot of a centre. Three steps: the error is below rounding where the depth is small against the radius of curvature.
template <class Patches, class Real>
[[gnu::always_inline]] inline PatchFoot<Real> find_foot(const Patches& patch, const PatchPoint<Real>& centre)
{
    const auto first = improve_foot(patch, centre, bounded_place(centre.one, centre.two));
    const auto second = improve_foot(patch, centre, first);
    return patch_foot(patch, centre, improve_foot(patch, centre, second));
}

} // namespace physics
