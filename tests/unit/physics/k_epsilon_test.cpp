// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/turbulence_resolved.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <initializer_list>

using physics::Turbulence;

namespace {

/// One step of a place where nothing is carried and nothing diffuses.
Turbulence advanced(const Turbulence& at, double strain, double dt)
{
    constexpr double syrup = 1.0; // [m2/s]: the bound of the eddy viscosity, 1e5 of that, is far
    const double produced = physics::production(physics::eddy_viscosity(physics::k_epsilon.c_mu, at, syrup, strain), strain, at.epsilon);
    const auto s = physics::turbulence_sources(at, produced, 0.0, dt);
    return {s.k.source / s.k.capacity, s.epsilon.source / s.epsilon.capacity};
}

} // namespace

TEST_CASE("turbulence without production decays by its power law, in one step or many")
{
    // NUMERICS U7: turnovers, k / k0, epsilon / epsilon0.
    struct Row {
        double time, k, epsilon;
    };
    for (const Row& row : {Row{0.1, 0.90876931, 0.83220633}, Row{1, 0.49211192, 0.25630829}, Row{10, 0.08011161, 0.00785408}}) {
        const Turbulence start{0.02, 0.3};
        const Turbulence once = advanced(start, 0, row.time * start.k / start.epsilon);
        CHECK(once.k / start.k == test::relative(row.k).epsilon(1e-7)); // eight digits are printed
        CHECK(once.epsilon / start.epsilon == test::relative(row.epsilon).epsilon(1e-6));
        Turbulence often = start;
        for (int n = 0; n < 100; ++n) often = advanced(often, 0, 0.01 * row.time * start.k / start.epsilon);
        CHECK(often.k == test::relative(once.k).epsilon(1e-13)); // round-off of 100 steps
        CHECK(often.epsilon == test::relative(once.epsilon).epsilon(1e-13));
    }
}

TEST_CASE("in a homogeneous shear production over dissipation tends to 2.0909, and all grows at its rate, in steps of any length")
{
    // NUMERICS U8: (C_2 - 1) / (C_1 - 1).
    const double shear = 100, balance = 0.92 / 0.44;
    for (const double step : {0.5, 0.1, 0.01}) { // of a turnover: growth by less than e
        Turbulence t{1e-3, 1e-2}, before;
        double dt = 0;
        for (double time = 0; time < 15; time += step) {
            before = t;
            dt = step * t.k / t.epsilon;
            t = advanced(t, shear * shear, dt);
        }
        const double rate = t.epsilon / t.k, ratio = physics::k_epsilon.c_mu * std::pow(shear / rate, 2);
        CHECK(ratio == test::relative(balance).epsilon(1e-4));
        CHECK(std::log(t.k / before.k) == test::relative((balance - 1) * rate * dt).epsilon(1e-4));
    }
    // On the way there, too: half the step or a hundredth of it makes no difference.
    Turbulence often{1e-3, 2e-3}, seldom = often;
    for (int n = 0; n < 100; ++n) often = advanced(often, 25.0, 0.01 * 0.2);
    seldom = advanced(seldom, 25.0, 0.2);
    CHECK(seldom.k == test::relative(often.k).epsilon(1e-12));
    CHECK(seldom.epsilon == test::relative(often.epsilon).epsilon(1e-12));
}

TEST_CASE("turbulence that diffusion holds in balance stays as it is, in steps of any length")
{
    // At the axis of a pipe nothing is produced: what dissipates comes by diffusion, k at epsilon, epsilon at C_2 epsilon^2 / k.
    const Turbulence at{0.01, 0.05};
    const double rate = at.epsilon / at.k, forcing = (physics::k_epsilon.c_2 - 1) * rate * rate;
    for (const double dt : {1e-6, 1e-2, 1.0, 1e3}) {
        const auto s = physics::turbulence_sources(at, 0.0, forcing, dt);
        const double k = (s.k.source + dt * at.epsilon) / s.k.capacity;
        const double epsilon = (s.epsilon.source + dt * physics::k_epsilon.c_2 * at.epsilon * rate) / s.epsilon.capacity;
        CHECK(k == test::relative(at.k).epsilon(1e-13));
        CHECK(epsilon == test::relative(at.epsilon).epsilon(1e-13));
    }
}

TEST_CASE("k and epsilon stay positive and finite for any step, strain and start")
{
    for (const double dt : {1e-12, 1e-3, 1.0, 1e6, 1e12})
        for (const double k : {physics::least_turbulence.k, 1e-6, 1.0, 1e4})
            for (const double epsilon : {physics::least_turbulence.epsilon, 1e-6, 1.0, 1e6})
                for (const double strain : {0.0, 1.0, 1e8}) {
                    const Turbulence t = advanced({k, epsilon}, strain, dt);
                    const bool sound = t.k > 0 && t.epsilon > 0 && std::isfinite(t.k) && std::isfinite(t.epsilon);
                    CHECK_MESSAGE(sound, dt, " ", k, " ", epsilon, " ", strain);
                }
}

TEST_CASE("strain a hundred times faster than turbulence does not make it without bounds")
{
    // NUMERICS D 36: S k / epsilon = 100 would produce 900 times what dissipates.
    const Turbulence at{0.1, 1.0};
    const double strain = std::pow(100 * at.epsilon / at.k, 2), eddy = physics::eddy_viscosity(physics::k_epsilon.c_mu, at, 1e-6, strain);
    CHECK(physics::production(eddy, strain, at.epsilon) <= 10 * at.epsilon);
    // Stagnation, plane or round: no normal stress is negative. The round one is what the bound is made for.
    const double along_plane = std::sqrt(strain / 4), along_axis = std::sqrt(strain / 3);
    CHECK(2 * eddy * along_plane <= 2 * at.k / 3);
    CHECK(2 * eddy * along_axis == test::relative(2 * at.k / 3).epsilon(1e-12));
    // In the logarithmic layer and in homogeneous shear nothing is bounded: S k / epsilon is 3.3 and 4.8 there.
    const double shear = std::pow(4.8 * at.epsilon / at.k, 2);
    CHECK(physics::eddy_viscosity(physics::k_epsilon.c_mu, at, 1e-6, shear) == test::relative(0.09 * 0.01).epsilon(1e-12));
}

TEST_CASE("friction at walls follows the viscous law below y* = 11.2, the logarithmic one above, and does not jump")
{
    const double nu = 1e-6, y = 1e-3;
    const auto at = [&](double distance) {
        return physics::wall_layer(std::pow(distance * nu / y, 2) / std::sqrt(physics::k_epsilon.c_mu), y, nu, 0);
    };
    for (const double distance : {0.0, 0.5, 1.0, 5.0, 11.0}) CHECK(at(distance).viscosity == 1.0);
    for (const double distance : {30.0, 300.0, 1e4})
        CHECK(at(distance).viscosity == test::relative(0.4187 * distance / std::log(9.793 * distance)).epsilon(1e-12));
    for (double distance = 0; distance < 200; distance += 0.01) {
        const auto low = at(distance), high = at(distance + 0.01);
        CHECK(std::abs(high.viscosity - low.viscosity) < 2e-3); // the slope is at most kappa / ln(E y*) = 0.09
        CHECK(std::abs(high.turbulent - low.turbulent) < 2e-3);
        const double rise = physics::wall_dissipation(high, 1.0, y, nu) / physics::wall_dissipation(low, 1.0, y, nu);
        if (distance > 1) CHECK(std::abs(rise - 1) < 0.04); // epsilon changes by y*^3 at most
    }
    // Far from the wall what is produced there dissipates there: the friction is C_mu^(1/2) k.
    const auto far = at(200.0);
    const double slip = far.friction_speed * std::log(9.793 * 200.0) / 0.4187, k = std::pow(far.friction_speed, 2) / 0.3;
    CHECK(physics::wall_production(far, slip, y, nu) == test::relative(physics::wall_dissipation(far, k, y, nu)).epsilon(0.01));
}

TEST_CASE("rough walls brake more, and grains as large as cells are no singularity")
{
    const double nu = 1e-6, y = 1e-2, k = 0.01;
    double before = physics::wall_layer(k, y, nu, 0).viscosity;
    for (const double roughness : {1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
        const auto layer = physics::wall_layer(k, y, nu, roughness);
        CHECK(layer.viscosity > before * (1 - 1e-12));
        CHECK(layer.viscosity <= layer.distance);
        before = layer.viscosity;
    }
}

TEST_CASE("fully rough walls follow Nikuradse's law to 2 % at any distance")
{
    const double nu = 1e-6, speed = 0.1, k = speed * speed / std::sqrt(physics::k_epsilon.c_mu);
    for (const double grains : {70.0, 200.0, 1000.0, 1e5}) // k_s+: the wall is fully rough from 70 on
        for (const double share : {1.0, 3.0, 10.0, 100.0, 1e4}) {
            const double roughness = grains * nu / speed, y = share * roughness;
            const auto layer = physics::wall_layer(k, y, nu, roughness);
            CHECK(layer.distance / layer.viscosity == test::relative(std::log(share) / 0.4187 + 8.5).epsilon(0.02));
        }
}

TEST_CASE("nearness of a wall damps eddy viscosity and decay as Abe, Kondoh and Nagano found")
{
    // By hand: y* = 14 and k^2 / (nu epsilon) = 200; then 3.1 and 6.5.
    const auto damping = [](double distance, double turbulence) {
        const double nu = 1e-6, epsilon = 0.01, y = distance * nu / std::sqrt(std::sqrt(nu * epsilon));
        return physics::wall_damping(std::sqrt(turbulence * nu * epsilon), epsilon, y, nu);
    };
    CHECK(damping(14, 200).viscosity == test::relative(0.39958 * 1.034586).epsilon(1e-5)); // five digits are given
    CHECK(damping(3.1, 6.5).decay == test::relative(0.39958 * 0.889636).epsilon(1e-5));
    CHECK(damping(1e4, 1e6).viscosity == test::relative(1).epsilon(1e-12));
    CHECK(damping(1e4, 1e6).decay == test::relative(1).epsilon(1e-12));
    for (const double distance : {0.0, 0.1, 10.0, 1e6, 1e300})
        for (const double turbulence : {1e-30, 1e-6, 1.0, 1e3, 1e30}) {
            const auto d = damping(distance, turbulence);
            CHECK(d.viscosity >= 0);
            CHECK(d.viscosity <= 1);
            CHECK(d.decay >= 0);
            CHECK(d.decay <= 1);
        }
}

TEST_CASE("friction at a wall fades and changes its sign with the flow, at any distance and without a jump")
{
    // NUMERICS D 37: friction is the viscosity of the layer times slip over distance, so what must not jump is the viscosity.
    const double nu = 1e-6, y = 1e-3;
    const auto at = [&](double distance) {
        return physics::wall_layer(std::pow(distance * nu / y, 2) / std::sqrt(physics::k_epsilon.c_mu), y, nu, 0);
    };
    for (const double distance : {0.5, 1.0, 5.0, 11.0, 11.2, 30.0, 1e4}) {
        const auto layer = at(distance), beyond = at(distance * (1 + 1e-6));
        CHECK(std::abs(beyond.viscosity / layer.viscosity - 1) < 2e-6); // it grows no faster than the distance
        CHECK(std::abs(beyond.turbulent - layer.turbulent) < 2e-5);
        const double slow = physics::wall_production(layer, 1e-12, y, nu), fast = physics::wall_production(layer, 1.0, y, nu);
        CHECK(slow <= 1e-12 * fast * (1 + 1e-12)); // none where the flow turns
        CHECK(physics::wall_dissipation(layer, layer.friction_speed * layer.friction_speed, y, nu) > 0);
    }
    CHECK(at(0.5).viscosity == 1.0);
    CHECK(at(1e4).viscosity == test::relative(0.4187e4 / std::log(9.793e4)).epsilon(1e-12));
    CHECK(physics::wall_production(at(0), 1.0, y, nu) == 0.0);
}
