// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact_laws.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

namespace {

physics::ContactParameters glass(double restitution, double friction)
{
    physics::ContactParameters p;
    p.model = physics::ContactModel::hertz;
    p.restitution = restitution;
    p.friction = friction;
    p.young_modulus = 4.8e10 / (2 * (1 - 0.2 * 0.2));
    p.shear_modulus = 4.8e10 / (4 * (2 - 0.2) * (1 + 0.2));
    return p;
}

/// A contact along x of reduced radius 5 mm and 50 um deep.
physics::ContactInput contact()
{
    physics::ContactInput in{};
    in.nx = in.mx = 1.0;
    in.overlap = 5e-5;
    in.radius = 5e-3;
    in.root_mass = 0.1;
    return in;
}

} // namespace

TEST_CASE("the springs of Hertz and Mindlin have their closed forms")
{
    const auto law = physics::hertz_contact(glass(1.0, 10.0), 1e-9);
    auto in = contact();
    in.sy = 1e-7;
    const auto out = law(in);
    const double contact_radius = std::sqrt(5e-3 * 5e-5); // a^2 = R delta
    CHECK(out.fx == test::relative(-4.0 / 3.0 * 2.5e10 * contact_radius * 5e-5).epsilon(1e-14));
    CHECK(out.fy == test::relative(-8.0 * 4.8e10 / 8.64 * contact_radius * 1e-7).epsilon(1e-14));
}

TEST_CASE("a growing load keeps the tangential force and a falling load keeps the displacement")
{
    const double step = 1e-7;
    const auto law = physics::hertz_contact(glass(1.0, 10.0), step);
    auto in = contact();
    in.sy = 1e-7;
    const double held = law(in).fy;
    in.vx = 1e-5 / step; // the overlap was 40 um
    const double before = std::sqrt(4e-5 / 5e-5);
    CHECK(law(in).fy == test::relative(before * held).epsilon(1e-12)); // stiffness of before times displacement
    in.vx = -in.vx;
    CHECK(law(in).fy == test::relative(held).epsilon(1e-12)); // stiffness of now times displacement
}

TEST_CASE("the general law gives the forces of each law that it unites")
{
    auto in = contact();
    in.vx = 0.3;
    in.vy = 0.2;
    in.wz = 0.1;
    in.sy = 1e-8;
    in.sz = -2e-8;
    auto soft = glass(0.7, 0.3);
    soft.model = physics::ContactModel::linear;
    const auto equal = [&](const physics::ContactOutput& a, const physics::ContactOutput& b) {
        CHECK(a.fx == test::relative(b.fx).epsilon(1e-14));
        CHECK(a.fy == test::relative(b.fy).epsilon(1e-14));
        CHECK(a.fz == test::relative(b.fz).epsilon(1e-14));
        CHECK(a.sy == test::relative(b.sy).epsilon(1e-13));
    };
    equal(physics::general_contact(glass(0.7, 0.3), 1e-8)(in), physics::hertz_contact(glass(0.7, 0.3), 1e-8)(in));
    equal(physics::general_contact(soft, 1e-8)(in), physics::linear_contact(soft, 1e-8)(in));
}

TEST_CASE("cohesion pulls with two pi times adhesion and reduced radius, and leaves friction alone")
{
    auto sticky = glass(1.0, 0.3);
    sticky.cohesion = 0.5;
    auto in = contact();
    in.sy = 1.0; // slides
    const auto with = physics::general_contact(sticky, 0.0)(in), without = physics::general_contact(glass(1.0, 0.3), 0.0)(in);
    CHECK(with.fx - without.fx == test::relative(2 * 3.14159265358979 * 0.5 * 5e-3).epsilon(1e-9)); // a small difference of forces
    CHECK(with.fy == without.fy);
    in.overlap = -1e-9;
    CHECK(physics::general_contact(sticky, 0.0)(in).fx == 0.0);
}

TEST_CASE("torques against rolling and twisting are limited by their coefficients")
{
    for (const auto model : {physics::RollingModel::constant, physics::RollingModel::spring}) {
        auto rough = glass(1.0, 0.3);
        rough.rolling = model;
        rough.rolling_friction = 0.1;
        rough.twisting_friction = 0.02;
        auto in = contact();
        in.uy = 1e4; // rolls fast about y
        const auto law = physics::general_contact(rough, 1e-3);
        const auto rolled = law(in);
        const double push = -rolled.fx;
        CHECK(rolled.my == test::relative(-0.1 * 5e-3 * push).epsilon(1e-12));
        CHECK(rolled.mx == 0.0);
        in.uy = 0.0;
        in.ux = -1e4; // twists
        CHECK(law(in).mx == test::relative(0.02 * 5e-3 * push).epsilon(1e-12));
    }
}

TEST_CASE("a spring against rolling holds 2.25 times the normal stiffness and the square of its arm")
{
    auto rough = glass(1.0, 0.3);
    rough.rolling_friction = 0.1;
    auto in = contact();
    in.ry = 1e-7;
    const double normal_stiffness = 2.0 * 2.5e10 * std::sqrt(5e-3 * 5e-5); // 2 E a
    CHECK(physics::general_contact(rough, 0.0)(in).my == test::relative(-2.25 * normal_stiffness * 0.25e-6 * 1e-7).epsilon(1e-12));
}

TEST_CASE("springs against rolling and twisting turn with the contact and keep their length")
{
    auto rough = glass(1.0, 0.3);
    rough.rolling_friction = rough.twisting_friction = 10.0;
    const auto law = physics::general_contact(rough, 0.0);
    auto in = contact();
    const double half = 0.005; // turn of half a step about z
    in.mx = std::cos(half), in.my = std::sin(half);
    in.nx = std::cos(2 * half), in.ny = std::sin(2 * half);
    in.rx = 1e-6; // twist about the normal of before
    in.rz = 2e-6;
    const auto out = law(in);
    CHECK(std::sqrt(out.rx * out.rx + out.ry * out.ry + out.rz * out.rz) == test::relative(std::sqrt(5.0) * 1e-6).epsilon(1e-13));
    CHECK(out.rz == test::relative(2e-6).epsilon(1e-4)); // second order in the turn
    CHECK(out.rx * in.nx + out.ry * in.ny == test::relative(1e-6).epsilon(1e-4));
}
