// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Surfaces of triangles for tests.
#include "physics/particles/triangle_mesh.hpp"
#include "tests/support/particle_scene.hpp"

namespace test {

using Triangles = std::vector<std::array<Vec3, 3>>;

inline void add_quad(Triangles& triangles, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
}

/// A cylinder about the x axis from x = 0 on, `around` strips of two long triangles, as drawing programs write it.
inline Triangles long_cylinder(double radius, double length, int around)
{
    Triangles triangles;
    const auto at = [&](int j, double x) {
        const double angle = 2 * std::numbers::pi * ((j % around) + 0.3) / around;
        return Vec3(x, radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int j = 0; j < around; ++j) add_quad(triangles, at(j, 0), at(j, length), at(j + 1, length), at(j + 1, 0));
    return triangles;
}

/// A drum about the x axis from x = 0 on, closed by flat ends, of about 2 `around` (`along` + 1) triangles.
inline Triangles drum(double radius, double length, int around, int along)
{
    Triangles triangles;
    const auto at = [&](int i, int j) {
        const double angle = 2 * std::numbers::pi * (j % around) / around;
        return Vec3(length * i / along, radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int j = 0; j < around; ++j) {
        for (int i = 0; i < along; ++i) add_quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        triangles.push_back({Vec3::Zero(), at(0, j), at(0, j + 1)});
        triangles.push_back({Vec3(length, 0, 0), at(along, j), at(along, j + 1)});
    }
    return triangles;
}

/// A rectangle.
inline Triangles sheet(const Vec3& corner, const Vec3& one, const Vec3& two)
{
    Triangles triangles;
    add_quad(triangles, corner, corner + one, corner + one + two, corner + two);
    return triangles;
}

inline physics::WallSurface surface(const Triangles& triangles, double smooth_angle = 0.26)
{
    return {physics::joined_triangles(triangles), smooth_angle};
}

} // namespace test
