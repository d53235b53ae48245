// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small scenes of particles for tests.
#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "physics/particles/advance.hpp"
#include "physics/particles/time_step.hpp"

#include <cstring>
#include <map>
#include <numbers>

namespace test {

using core::Vec3;

inline core::Sphere sphere(std::int64_t id, const Vec3& position, double radius, double density = 2500.0)
{
    core::Sphere s;
    s.id = id;
    s.position = position;
    s.radius = radius;
    s.density = density;
    return s;
}

inline physics::ParticleParameters material(double stiffness, double restitution, double friction)
{
    physics::ParticleParameters p;
    p.pairs = p.walls = {{stiffness, 2.0 / 7.0, restitution, friction}};
    return p;
}

inline void run(physics::ParticleDynamics& dynamics, const Vec3& gravity, int steps, const core::Team& team = core::SerialTeam{})
{
    physics::settle(dynamics, physics::DryMotion{gravity}, steps, team);
}

/// Place of particle `id` in the set.
inline int place(const core::ParticleSet& particles, std::int64_t id)
{
    for (int i = 0; i < particles.owned; ++i)
        if (particles.id[std::size_t(i)] == id) return i;
    throw core::Error(core::text("no particle ", id));
}

/// Position, velocity and spin of all owned particles by id.
inline std::map<std::int64_t, std::array<double, 9>> state(const core::ParticleSet& p)
{
    std::map<std::int64_t, std::array<double, 9>> s;
    for (int i = 0; i < p.owned; ++i) {
        auto& row = s[p.id[std::size_t(i)]];
        for (std::size_t a = 0; a < 3; ++a) {
            row[a] = p.position[a][std::size_t(i)];
            row[3 + a] = p.velocity[a][std::size_t(i)];
            row[6 + a] = p.spin[a][std::size_t(i)];
        }
    }
    return s;
}

/// `n` spheres of 2 and 3 mm on a cubic lattice of spacing 3.2 mm from `corner` on, nx by ny in a layer, with random velocities.
inline std::vector<core::Sphere> loose_lattice(int n, int nx, int ny, const Vec3& corner, double speed)
{
    std::vector<core::Sphere> spheres;
    for (int k = 0; k < n; ++k) {
        const Vec3 cell(k % nx, k / nx % ny, k / (nx * ny));
        const auto u = core::random_uniform(7, k, 0), w = core::random_uniform(7, k, 1);
        auto s = sphere(k, corner + 3.2e-3 * (cell + Vec3::Constant(0.5)), k % 3 == 0 ? 1.5e-3 : 1e-3, 2000.0);
        for (int a = 0; a < 3; ++a) {
            s.velocity[a] = speed * (2.0 * u[std::size_t(a)] - 1.0);
            s.spin[a] = 1000.0 * speed * (2.0 * w[std::size_t(a)] - 1.0);
        }
        spheres.push_back(s);
    }
    return spheres;
}

} // namespace test
