// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/drag.hpp"
#include "physics/coupling/lift.hpp"
#include "physics/coupling/parameters.hpp"
#include "physics/coupling/torque.hpp"
#include "tests/support/relative.hpp"

#include <doctest/doctest.h>

using core::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

physics::DragInput water(double slip, double phi, double diameter) { return {slip, phi, diameter, 1000.0, 1e-3}; }

} // namespace

TEST_CASE("every drag law is finite at zero slip and has its creeping limit")
{
    const double stokes = 3.0 * pi * 1e-3 * 1e-3;
    CHECK(physics::drag_schiller_naumann(water(0.0, 1.0, 1e-3)) == test::relative(stokes).epsilon(1e-14));
    CHECK(physics::drag_wen_yu(water(0.0, 0.9, 1e-3)) == test::relative(stokes * std::pow(0.9, -2.65)).epsilon(1e-14));
    const double volume = pi / 6.0 * 1e-9;
    CHECK(physics::drag_ergun(water(0.0, 0.4, 1e-3)) == test::relative(volume * 150.0 * 0.6 * 1e-3 / (0.4 * 1e-6)).epsilon(1e-14));
    // Dalla Valle's 4.8^2 = 23.04 stands for 24.
    CHECK(physics::drag_di_felice(water(0.0, 1.0, 1e-3)) == test::relative(stokes * 23.04 / 24.0).epsilon(1e-12));
}

TEST_CASE("a fixed bed with Ergun's drag has Ergun's pressure drop under set II")
{
    // NUMERICS C5.1: phi 0.4, d 1 mm, water, superficial velocity 0.001, 0.01, 0.1 m/s.
    const double superficial[] = {0.001, 0.01, 0.1}, drop[] = {860.16, 10078.1, 248437.5};
    const double phi = 0.4, d = 1e-3, volume = pi / 6.0 * d * d * d;
    for (int i = 0; i < 3; ++i) {
        const double u = superficial[i] / phi;
        const double force = physics::drag_ergun(water(u, phi, d)) * u * (1.0 - phi) / volume;
        CHECK(force / phi == test::relative(drop[i]).epsilon(1e-5)); // printed to six digits
    }
}

TEST_CASE("the drag expected of a grain carries its weight at the slip it is for")
{
    using physics::DragLaw;
    physics::CouplingParameters p;
    for (const DragLaw law : {DragLaw::di_felice, DragLaw::gidaspow, DragLaw::kawaguchi, DragLaw::schiller_naumann}) {
        p.drag = law;
        for (const double diameter : {1e-5, 2e-4, 5e-3}) // from creeping to a Reynolds number of thousands
            for (const double fraction : {0.45, 0.7, 1.0}) {
                const double weight = pi / 6.0 * std::pow(diameter, 3) * 1650.0 * 9.81;
                const double drag = physics::settling_drag(p, weight, fraction, diameter);
                // Sixteen rounds, each of which leaves at most half of the error of the first, some factor of a hundred.
                CHECK(std::abs(physics::drag_coefficient(p, weight / drag, fraction, diameter) / drag - 1.0) < 1e-4);
            }
    }
}

TEST_CASE("the seed's law jumps at phi = 0.8 as published, the default does not")
{
    // Ergun over Wen-Yu at Re = 1 and 100: 1.06 and 1.73 (NUMERICS A9).
    const double reynolds[] = {1.0, 100.0}, jump[] = {1.06, 1.73};
    for (int i = 0; i < 2; ++i) {
        const double slip = reynolds[i] * 1e-3 / (1000.0 * 0.8 * 1e-3);
        CHECK(physics::drag_gidaspow(water(slip, 0.8, 1e-3)) / physics::drag_gidaspow(water(slip, 0.8 + 1e-12, 1e-3)) ==
              test::relative(jump[i]).epsilon(0.005)); // printed to three digits
        CHECK(physics::drag_di_felice(water(slip, 0.8, 1e-3)) / physics::drag_di_felice(water(slip, 0.8 + 1e-6, 1e-3)) ==
              test::relative(1.0).epsilon(1e-4)); // Lipschitz: some 5 times the change of phi
    }
}

TEST_CASE("the seed's drag has the numbers that its authors print")
{
    // 2 mm in water at 0.1 m/s, phi = 0.9: Re = 180, 1 + 0.15 Re^0.687 = 6.314513, phi^-2.7 = 1.329062, 3 pi mu d = 1.884956e-5.
    CHECK(physics::drag_kawaguchi(water(0.1, 0.9, 2e-3)) == test::relative(1.884956e-5 * 6.314513 * 1.329062).epsilon(1e-6));
    // At 1 m/s: Re = 1800, 0.43 / 24 Re = 32.25.
    CHECK(physics::drag_kawaguchi(water(1.0, 0.9, 2e-3)) == test::relative(1.884956e-5 * 32.25 * 1.329062).epsilon(1e-6));
    // phi = 0.5: V (150 0.5 mu / (0.5 d2) + 1.75 rho 0.1 / d) = 4.18879e-9 (37500 + 87500).
    CHECK(physics::drag_kawaguchi(water(0.1, 0.5, 2e-3)) == test::relative(5.235988e-4).epsilon(1e-6));
    // The switch is sharp, and the dense side includes 0.8.
    CHECK(physics::drag_kawaguchi(water(0.1, 0.8, 2e-3)) == physics::drag_ergun(water(0.1, 0.8, 2e-3)));
}

TEST_CASE("added mass of one sphere is half the displaced fluid, of a suspension more")
{
    CHECK(physics::added_mass_zuber(0.0) == 0.5);
    CHECK(physics::added_mass_zuber(0.25) == test::relative(1.0).epsilon(1e-14));
    physics::CouplingParameters p;
    CHECK(physics::added_mass_coefficient(p, 0.75) == 0.5);
    p.added_mass_law = physics::AddedMassLaw::zuber;
    CHECK(physics::added_mass_coefficient(p, 0.75) == test::relative(1.0).epsilon(1e-14));
}

TEST_CASE("lift points where it must")
{
    physics::SpinInput in;
    in.diameter = 1e-3;
    in.density = 1000.0;
    in.viscosity = 1e-3;
    in.slip = Vec3(-1.0, 0.0, 0.0); // the grain moves along +x
    in.spin = Vec3(0.0, 0.0, 10.0);
    const Vec3 magnus = physics::magnus_lift(in);
    CHECK((magnus - Vec3(0.0, pi / 8.0 * 1000.0 * 1e-9 * 10.0, 0.0)).norm() < 1e-12 * magnus.norm());

    in.spin = Vec3::Zero();
    in.vorticity = Vec3(0.0, 0.0, -20.0); // u = 20 y along x
    in.slip = Vec3(0.01, 0.0, 0.0);       // the grain lags
    CHECK(physics::shear_lift(in).y() > 0.0);
    // By hand: 1.615 d^2 sqrt(rho mu |w|) U f = 1.615e-6 sqrt 20 0.01 f; Re = 10, root = 0.3314 sqrt(1), f = 0.6686 / e + 0.3314.
    CHECK((physics::shear_lift(in) - Vec3(0.0, 1.615e-6 * std::sqrt(20.0) * 0.01 * (0.6686 * std::exp(-1.0) + 0.3314), 0.0)).norm() <
          1e-12 * physics::shear_lift(in).norm());
    in.slip = Vec3(-0.01, 0.0, 0.0);
    CHECK(physics::shear_lift(in).y() < 0.0);
    in.slip = Vec3::Zero();
    CHECK(physics::shear_lift(in) == Vec3::Zero());
}

TEST_CASE("the lift of Lun and Liu falls from that of Rubinow and Keller to what was measured at large Reynolds numbers")
{
    physics::CouplingParameters p; // water
    const double d = 2e-3;
    const auto share = [&](double reynolds) { return physics::magnus_share(p, reynolds * 1e-6 / d, d); };
    CHECK(share(0.0) == 1.0);
    CHECK(share(0.5) == 1.0);
    CHECK(share(1.0001) == test::relative(1.0).epsilon(1e-4)); // 0.178 + 0.822
    // By hand: 100^-0.522 = 10^-1.044 = 0.090365, 1000^-0.522 = 10^-1.566 = 0.027164.
    CHECK(share(100.0) == test::relative(0.25228).epsilon(1e-4));
    CHECK(share(1000.0) == test::relative(0.20033).epsilon(1e-4));
    for (const double reynolds : {550.0, 1600.0})
        CHECK(std::abs(share(reynolds) / physics::magnus_share_tsuji - 1.0) < 0.1); // which is known to 25 %
    p.magnus = physics::MagnusLaw::rubinow_keller;
    CHECK(share(1000.0) == 1.0);
    p.magnus = physics::MagnusLaw::tsuji;
    CHECK(share(1.0) == physics::magnus_share_tsuji);
}

TEST_CASE("spin decays in fluid at rest as exp(-60 mu t / (rho_p d^2)), and turns with the shear")
{
    const double d = 2e-3, density = 2000.0, mass = density * pi / 6.0 * d * d * d, inertia = 0.1 * mass * d * d;
    const double factor = physics::torque_factor(1.0, d, 1000.0, 1e-3);
    const Vec3 spin = physics::spin_after(Vec3(0.0, 1.0, 0.0), Vec3::Zero(), factor, inertia, 0.05);
    CHECK(spin.y() == test::relative(std::exp(-60.0 * 1e-3 * 0.05 / (density * d * d))).epsilon(1e-12));
    CHECK(physics::spin_after(Vec3::Zero(), Vec3(0.0, 0.0, -1.0), factor, inertia, 0.05).z() < 0.0);
    // The two branches meet at Re = 32 to 0.2 %: 6.283 and 6.293.
    const double edge = 32.0 * 1e-3 / (1000.0 * d * d);
    CHECK(physics::torque_factor(edge * 1.0001, d, 1000.0, 1e-3) / factor == test::relative(6.293 / 6.283).epsilon(5e-4));
}
