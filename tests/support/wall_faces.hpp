// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Walls made of faces for tests.
#include "tests/support/particle_scene.hpp"

namespace test {

struct Faces {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 4>> quads;
};

/// A pipe about the x axis, `around` by `along` faces, normals inward.
inline Faces pipe(double radius, double length, int around, int along)
{
    Faces f;
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j < around; ++j) {
            const double angle = 2 * std::numbers::pi * (j + 0.3) / around;
            f.vertices.push_back(Vec3(length * i / along, radius * std::cos(angle), radius * std::sin(angle)));
        }
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const int a = i * around + j, b = i * around + (j + 1) % around;
            f.quads.push_back({a, a + around, b + around, b});
        }
    return f;
}

} // namespace test
