// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A ball that rolls once round inside a cylinder about the x axis, from its lowest point, without loss.
#include "tests/support/particle_scene.hpp"
#include <optional>

namespace test {

struct RollingBall {
    double cylinder = 25e-3, radius = 1e-3; ///< [m]
    double at = 20e-3, drift = 0.0;         ///< Along the axis: place [m] and velocity [m/s] at the start.

    struct End {
        double energy_error; ///< Of the whole turn, over the energy at the start [-].
        double at;           ///< Along the axis [m].
    };
    /// Fast enough for the whole circle, speed^2 > 2.7 g (R - r); rolling from the start, pressed on by the centrifugal force.
    [[nodiscard]] End roll(std::vector<physics::Wall> walls, std::optional<physics::WallSurface> surface = {}) const
    {
        const double arm = cylinder - radius, stiffness = 1e5, speed = 1.5, g = 9.81;
        const auto parameters = material(stiffness, 1.0, 0.8);
        auto ball = sphere(0, Vec3::Zero(), radius);
        const double mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * ball.density;
        physics::ParticleDynamics dynamics({}, parameters, std::move(walls), physics::contact_time(parameters.walls[0], mass) / 50);
        if (surface) dynamics.add_surface(std::move(*surface));
        const double press = mass * (speed * speed / arm + g) / stiffness;
        ball.position = Vec3(at, -(arm + press), 0);
        ball.velocity = Vec3(drift, 0, speed);
        ball.spin = Vec3(speed / (radius - press), 0, -drift / (radius - press));
        dynamics.particles.add(ball);
        const auto energy = [&] {
            const auto& p = dynamics.particles;
            return 0.5 * mass * p.velocity_of(0).squaredNorm() + 0.2 * mass * radius * radius * p.spin_of(0).squaredNorm() +
                   mass * g * p.position[1][0];
        };
        const double before = energy();
        run(dynamics, Vec3(0, -g, 0), int(2 * std::numbers::pi * arm / speed / dynamics.step()));
        return {std::abs(energy() - before) / before, dynamics.particles.position[0][0]};
    }
};

} // namespace test
