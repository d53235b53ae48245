// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The benchmarks of Chung and Ooi (2011), Benchmark tests for verifying discrete element modelling codes at particle impact level,
// with Hertz' and Mindlin's springs.
#include "tests/support/impact.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using test::Impact, test::Rebound, test::Solid, test::Vec3;

namespace {

constexpr Solid glass{4.8e10, 0.20, 2800}, limestone{2.0e10, 0.25, 2500}, aluminium{7.0e10, 0.30, 2699}, magnesium{4.0e10, 0.35, 1800};
constexpr Solid alumina{3.8e11, 0.23, 4000}, alloy{7.0e10, 0.33, 2700}, steel{2.08e11, 0.30, 7850}, polyethylene{1.0e9, 0.40, 1400};
constexpr Solid nylon{2.5e9, 0.40, 1000};

Impact impact_of(const Solid& solid, double restitution, double friction, double radius, const Vec3& velocity)
{
    Impact impact;
    impact.contact = test::hertz(solid, solid, restitution, friction);
    impact.density = solid.density;
    impact.radius = radius;
    impact.velocity = velocity;
    return impact;
}

/// Whether the spring across the normal has a dashpot beside it.
enum class Dashpot { none, tangential };

/// Test 4 once more, in three numbers: the sphere's overlap, its speed along the wall and the slip of its surface, in steps of a
/// hundred-thousandth of the contact. @returns the speed along the wall after over before.
double integrated(const Solid& solid, double degrees, Dashpot dashpot)
{
    const double mu = 0.092, zeta = 0.006457; // restitution 0.98
    const double angle = degrees * std::numbers::pi / 180, radius = 2.5e-3, mass = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
    const double young = solid.young / (2 * (1 - solid.poisson * solid.poisson) * solid.density);
    const double shear = solid.young / (4 * (2 - solid.poisson) * (1 + solid.poisson) * solid.density);
    const double damping = 2 * std::sqrt(5.0 / 6) * zeta, step = 1.2e-10; // contacts last 11 to 20 us
    double overlap = 0, speed = 3.9 * std::cos(angle), along = 3.9 * std::sin(angle), spin = 0, force = 0, before = 0;
    do {
        const double reach = std::sqrt(radius * overlap), stiffness = 8 * shear * reach, arm = radius - overlap;
        const double normal = 4.0 / 3 * young * reach * overlap + damping * std::sqrt(2 * young * reach * mass) * speed;
        const double viscous = dashpot == Dashpot::none ? 0.0 : damping * std::sqrt(2.0 / 7 * stiffness * mass), slip = along - spin * arm;
        const double spring = (speed < 0 && before > 0 ? stiffness / before : 1.0) * force - stiffness * slip * step;
        const double trial = spring - viscous * slip, limit = mu * std::max(0.0, normal);
        const bool slides = std::abs(trial) > limit;
        const double friction = slides ? std::copysign(limit, trial) : trial;
        force = slides ? friction : spring;
        before = stiffness;
        speed -= std::max(0.0, normal) / mass * step;
        along += friction / mass * step;
        spin -= 2.5 * friction * arm / (mass * radius * radius) * step;
        overlap += speed * step;
    } while (overlap > 0);
    return along / (3.9 * std::sin(angle));
}

/// Test 4 by the solver.
Rebound oblique(const Solid& solid, double degrees, int steps)
{
    const double angle = degrees * std::numbers::pi / 180;
    Impact impact = impact_of(solid, 0.98, 0.092, 2.5e-3, 3.9 * Vec3(std::sin(angle), 0, -std::cos(angle)));
    impact.steps = steps;
    return test::rebound(impact);
}

/// Sphere and wall, or sphere and another, of one material with friction 0.4 and restitution 0.5: test 6 and 8.
struct Spun {
    Solid solid;
    Impact::Against against = Impact::Against::wall;
    double speed = 0.2; ///< [m/s]
    int steps = 4000;
};

/// @param x  7/2 of friction's impulse over the slip before.
/// @returns the speed of the contact point after over before, times -1; it moves by spin alone before.
double reversal(const Spun& spun, double x)
{
    const double radius = 0.1, slip = 3.5 * 0.4 * 1.5 * spun.speed / x;
    Impact impact = impact_of(spun.solid, 0.5, 0.4, radius, Vec3(0, 0, -spun.speed));
    impact.spin = Vec3(0, slip / radius, 0);
    impact.against = spun.against;
    impact.steps = spun.steps;
    impact.other.radius = 0.5;
    impact.other.density = 1000 * spun.solid.density;
    if (spun.against == Impact::Against::sphere)
        impact.contact = test::hertz(spun.solid, {1000 * spun.solid.young, spun.solid.poisson, 0}, 0.5, 0.4);
    const Rebound out = test::rebound(impact);
    return (out.velocity.x() - radius * out.spin.y()) / slip; // before: - slip
}

} // namespace

TEST_CASE("1: two elastic spheres meet with the force, the overlap and the duration of Hertz")
{
    const struct {
        Solid solid;
        double force, overlap, time;
    } cases[] = {{glass, 10.697e3, 274.11e-6, 40.339e-6}, {limestone, 7.1082e3, 368.30e-6, 54.201e-6}}; // exact, five digits
    for (const auto& c : cases) {
        Impact impact = impact_of(c.solid, 1.0, 0.35, 0.01, Vec3(0, 0, -10));
        impact.against = Impact::Against::mirror;
        const Rebound out = test::rebound(impact);
        CHECK(out.greatest_force == test::relative(c.force).epsilon(1e-4));
        CHECK(out.greatest_overlap == test::relative(c.overlap).epsilon(1e-4));
        CHECK(out.duration == test::relative(c.time).epsilon(1e-3)); // counted in steps of 1/4000
        CHECK(out.velocity.z() == test::relative(10).epsilon(1e-6));
    }
}

TEST_CASE("2: an elastic sphere meets a wall of its material")
{
    const struct {
        Solid solid;
        double force, overlap, time;
    } cases[] = {{aluminium, 11.3699e3, 49.717e-6, 731.66e-6}, {magnesium, 7.2327e3, 52.123e-6, 767.07e-6}};
    for (const auto& c : cases) {
        // the wall is rigid: only the sphere yields
        Impact impact = impact_of(c.solid, 1.0, 0.35, 0.1, Vec3(0, 0, -0.2));
        impact.contact.young_modulus *= 2;
        const Rebound out = test::rebound(impact);
        CHECK(out.greatest_force == test::relative(c.force).epsilon(1e-4));
        CHECK(out.greatest_overlap == test::relative(c.overlap).epsilon(1e-4));
        CHECK(out.duration == test::relative(c.time).epsilon(1e-3));
    }
}

TEST_CASE("4: an oblique impact slides throughout from 30 degrees on, and sticks below as the paper has it")
{
    const auto exact = [](double degrees) { return 1 - 0.092 * 1.98 / std::tan(degrees * std::numbers::pi / 180); };
    for (const Solid& solid : {alumina, alloy}) {
        // While the contact opens, the spring at Coulomb's limit gets shorter by mu E / (6 G) times the speed of opening: it stays there
        // although the surface has turned round, down to tan = mu (3.5 (1 + e) - e E / (6 G)): 29.6 and 29.4 degrees. First order: 4e-6.
        CHECK(std::abs(integrated(solid, 30, Dashpot::none) - exact(30)) < 1e-5);
        CHECK(integrated(solid, 28, Dashpot::none) - exact(28) > 1e-3);
        // Our springs have a dashpot beside them, which turns with the surface: below tan = 3.5 mu (1 + e), 32.5 degrees, it takes a little
        // of the friction. First order: 4e-5 of the springs' 64000 steps.
        CHECK(integrated(solid, 30, Dashpot::tangential) - exact(30) == doctest::Approx(1.25e-4).scale(0).epsilon(0.1));
        CHECK(std::abs(oblique(solid, 30, 64000).velocity.x() / (3.9 * 0.5) - integrated(solid, 30, Dashpot::tangential)) < 1e-5);
        for (const double degrees : {33.0, 35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
            const double along = 3.9 * std::sin(degrees * std::numbers::pi / 180);
            CAPTURE(degrees);
            CHECK(std::abs(oblique(solid, degrees, 4000).velocity.x() / along - exact(degrees)) < 1e-4);
        }
    }
    // read from the paper's curves, to 1 per cent; another per cent for the tangential dashpot, which the paper does not have
    const double sticking[][2] = {{10, .687}, {15, .624}, {20, .616}, {25, .634}};
    for (const auto& [degrees, ratio] : sticking) { // what sticks converges more slowly
        CAPTURE(degrees);
        CHECK(oblique(alumina, degrees, 64000).velocity.x() / (3.9 * std::sin(degrees * std::numbers::pi / 180)) ==
              test::relative(ratio).epsilon(0.02));
    }
}

TEST_CASE("5: beyond the angle of sliding the surface keeps what friction does not take")
{
    const double radius = 1e-5, friction = 0.3;
    for (const Solid& solid : {steel, polyethylene})
        for (const double x : {7.0, 7.5, 9.0, 12.0})                          // slip over mu v_n
            for (const double vn : {solid.young > 1e10 ? 5.0 : 0.05, 1e-4}) { // polyethylene at 5 m/s is squeezed by a tenth
                const double unit = friction * vn;
                Impact impact = impact_of(solid, 1.0, friction, radius, Vec3(x * unit, 0, -vn));
                const Rebound out = test::rebound(impact);
                // Friction acts where the surfaces touch, the overlap nearer than a radius: over a contact of Hertz' spring 0.8176 of the
                // greatest one, B(7/5, 1/2) / 2.
                const double arm = 1 - 0.81757 * out.greatest_overlap / radius;
                CAPTURE(x);
                CAPTURE(vn);
                CHECK(radius * out.spin.y() / unit == test::relative(5 * arm).epsilon(1e-4));
                CHECK(std::abs((out.velocity.x() - radius * out.spin.y()) / unit - (x - 2 - 5 * arm)) < 1e-3);
                if (vn < 0.01) CHECK(std::abs((out.velocity.x() - radius * out.spin.y()) / unit - (x - 7)) < 1e-3);
            }
}

TEST_CASE("6 and 8: a spinning sphere that slides throughout reverses by friction's impulse, on a wall and on a heavy sphere")
{
    for (const Solid& solid : {alloy, nylon})
        for (const auto against : {Impact::Against::wall, Impact::Against::sphere})
            for (const double x : {0.969, 0.771, 0.573, 0.374, 0.176}) {
                CAPTURE(x);
                CHECK(std::abs(reversal({solid, against}, x) - (x - 1)) < 1e-3); // overlaps of up to 1e-3 radii make arms shorter
                CHECK(std::abs(reversal({solid, against, 1e-3, 16000}, x) - (x - 1)) < 1e-4);
            }
}

TEST_CASE("7: two spheres with opposite spins rebound straight and keep their spins")
{
    for (const Solid& solid : {alloy, nylon}) {
        physics::ParticleParameters parameters;
        parameters.pairs = {test::hertz(solid, solid, 0.5, 0.4)};
        physics::ParticleDynamics dynamics({}, parameters, {}, 1e-6);
        for (int k = 0; k < 2; ++k) {
            auto ball = test::sphere(k, Vec3(0.2000001 * k, 0, 0), 0.1, solid.density);
            ball.velocity = Vec3(k == 0 ? 0.2 : -0.2, 0, 0);
            ball.spin = Vec3(0, 0, k == 0 ? 4 : -4);
            dynamics.particles.add(ball);
        }
        test::run(dynamics, Vec3::Zero(), 20000);
        const auto state = test::state(dynamics.particles);
        CHECK(state.at(0)[3] < -0.09);           // rebounded at 0.1
        CHECK(std::abs(state.at(0)[4]) < 1e-12); // rounding
        CHECK(state.at(0)[8] == test::relative(4).epsilon(1e-12));
    }
}
