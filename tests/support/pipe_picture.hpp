// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture to try the renderer on: grains of two sizes at the bottom of a horizontal pipe of glass.
#include "io/picture/picture.hpp"
#include <cmath>
#include <numbers>

namespace support {

inline io::Surface pipe_wall(float radius, float length)
{
    io::Surface wall;
    constexpr int around = 96, along = 24;
    for (int i = 0; i <= along; ++i)
        for (int k = 0; k < around; ++k) {
            const float angle = 2.0f * std::numbers::pi_v<float> * float(k) / around;
            wall.points.push_back({length * float(i) / along, radius * std::cos(angle), radius * std::sin(angle)});
            const int next = (k + 1) % around, here = i * around;
            if (i == along) continue;
            wall.triangles.push_back({here + k, here + next, here + around + k});
            wall.triangles.push_back({here + next, here + around + next, here + around + k});
        }
    return wall;
}

/// Pushes overlapping spheres apart and into the pipe, once.
inline void push_apart(std::vector<io::Sphere>& spheres, float radius, float length)
{
    for (std::size_t a = 0; a < spheres.size(); ++a)
        for (std::size_t b = a + 1; b < spheres.size(); ++b) {
            io::Sphere &p = spheres[a], &q = spheres[b];
            const float reach = p.radius + q.radius, x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
            const float square = x * x + y * y + z * z;
            if (square >= reach * reach || square == 0.0f) continue;
            const float move = 0.5f * (reach / std::sqrt(square) - 1.0f);
            p.x -= move * x, p.y -= move * y, p.z -= move * z;
            q.x += move * x, q.y += move * y, q.z += move * z;
        }
    for (io::Sphere& s : spheres) {
        const float out = std::hypot(s.y, s.z), most = radius - s.radius;
        if (out > most) s.y *= most / out, s.z *= most / out;
        s.x = std::min(std::max(s.x, s.radius), length - s.radius);
    }
}

/// @param count  grains; two of three are small (2 mm), the others 3 mm
inline io::PictureScene pipe_picture(int count, double aspect, int steps = 220)
{
    constexpr float radius = 0.025f, length = 0.09f;
    io::PictureScene scene;
    for (int n = 0; n < count; ++n) {
        const bool large = n % 3 == 2;
        const auto spread = [n](double irrational) { return float(std::fmod(n * irrational, 1.0)); };
        scene.spheres.push_back({length * spread(0.7548776662466927), radius * (1.2f * spread(0.5698402909980532) - 0.8f),
                                 radius * (1.2f * spread(0.4301597090019468) - 0.6f), large ? 0.0015f : 0.001f,
                                 io::species_colour(large ? 1 : 0)});
    }
    for (int step = 0; step < steps; ++step) {
        for (io::Sphere& s : scene.spheres) s.y -= 1e-4f;
        push_apart(scene.spheres, radius, length);
    }
    for (int step = 0; step < 20; ++step) push_apart(scene.spheres, radius, length);
    scene.walls.push_back(pipe_wall(radius, length));
    scene.camera = io::fit_camera({0, -radius, -radius}, {length, radius, radius}, {-0.55, -0.42, -0.78}, aspect);
    scene.caption = {"Grains in a pipe", "t = 0.450 s", {{io::species_colour(0), "S: 2 mm"}, {io::species_colour(1), "L: 3 mm"}}, {}};
    return scene;
}

} // namespace support
