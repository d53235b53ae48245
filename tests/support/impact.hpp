// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A single impact, of a sphere on a flat wall or of two spheres, followed step by step.
#include "tests/support/particle_scene.hpp"

namespace test {

/// Young's modulus [Pa], Poisson's ratio, density [kg/m3].
struct Solid {
    double young, poisson, density;
};

/// Two bodies of such materials as Hertz' springs see them.
inline physics::ContactParameters hertz(const Solid& a, const Solid& b, double restitution, double friction)
{
    const auto soft = [](const Solid& s) { return 2 * (2 - s.poisson) * (1 + s.poisson) / s.young; };
    physics::ContactParameters p;
    p.model = physics::ContactModel::hertz;
    p.restitution = restitution;
    p.friction = friction;
    p.young_modulus = 1 / ((1 - a.poisson * a.poisson) / a.young + (1 - b.poisson * b.poisson) / b.young);
    p.shear_modulus = 1 / (soft(a) + soft(b));
    return p;
}

/// What a sphere brings to an impact along -z, and what it takes away. The other stands still, or mirrors it.
struct Impact {
    enum class Against { wall, mirror, sphere };
    physics::ContactParameters contact;
    double radius = 1e-3, density = 2500.0;
    Vec3 velocity = -Vec3::UnitZ(), spin = Vec3::Zero();
    Against against = Against::wall;
    core::Sphere other{}; ///< Against::sphere: radius and density.
    int steps = 4000;     ///< In a contact.
    double phase = 0.5;   ///< Share of the approach of one step that is left before the first force.
};

struct Rebound {
    Vec3 velocity, spin;
    double greatest_force = 0.0, greatest_overlap = 0.0, duration = 0.0; ///< As far as steps show them.
};

/// The time that the impact takes, as the law says [s].
inline double impact_time(Impact& impact)
{
    const auto mass = [](double radius, double density) { return 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * density; };
    const double m = mass(impact.radius, impact.density), approach = -impact.velocity.z();
    physics::ContactBody body{m, impact.radius};
    impact.contact.impact_speed = approach;
    if (impact.against == Impact::Against::mirror) {
        body = {m / 2, impact.radius / 2};
        impact.contact.impact_speed = 2 * approach;
    } else if (impact.against == Impact::Against::sphere) {
        const double other = mass(impact.other.radius, impact.other.density), r = impact.other.radius;
        body = {m * other / (m + other), impact.radius * r / (impact.radius + r)};
    }
    return physics::contact_time(impact.contact, body);
}

/// Follows the impact until the contact has opened.
inline Rebound rebound(Impact impact)
{
    using Against = Impact::Against;
    const double time = impact_time(impact), step = time / impact.steps, approach = -impact.velocity.z();
    physics::ParticleParameters parameters;
    parameters.pairs = parameters.walls = {impact.contact};
    std::vector<physics::Wall> walls;
    if (impact.against == Against::wall) walls.push_back(physics::PlaneWall{});
    physics::ParticleDynamics dynamics({}, parameters, walls, step);
    const double gap = impact.phase * approach * step;
    core::Sphere ball = sphere(0, Vec3(0, 0, impact.radius + gap), impact.radius, impact.density);
    ball.velocity = impact.velocity;
    ball.spin = impact.spin;
    dynamics.particles.add(ball);
    if (impact.against == Against::mirror) {
        ball.id = 1;
        ball.position *= -1;
        ball.velocity.z() *= -1;
        ball.velocity.x() *= -1;
        dynamics.particles.add(ball); // the same spin: the surfaces slide against each other
    }
    if (impact.against == Against::sphere)
        dynamics.particles.add(sphere(1, Vec3(0, 0, -impact.other.radius), impact.other.radius, impact.other.density));
    Rebound out;
    const auto& p = dynamics.particles;
    const auto overlap = [&] {
        if (impact.against == Against::wall) return impact.radius - p.position[2][0];
        return p.radius[0] + p.radius[1] - (p.position_of(0) - p.position_of(1)).norm();
    };
    bool touched = false;
    for (int n = 0; n < 4 * impact.steps; ++n) {
        const Vec3 before = p.velocity_of(place(p, 0));
        run(dynamics, Vec3::Zero(), 1);
        const double depth = overlap();
        out.greatest_force = std::max(out.greatest_force, p.mass[0] * std::abs(p.velocity_of(place(p, 0)).z() - before.z()) / step);
        out.greatest_overlap = std::max(out.greatest_overlap, depth);
        if (depth > 0) out.duration += step;
        touched = touched || depth > 0;
        if (touched && depth < -approach * step) break;
    }
    out.velocity = p.velocity_of(place(p, 0));
    out.spin = p.spin_of(place(p, 0));
    return out;
}

} // namespace test
