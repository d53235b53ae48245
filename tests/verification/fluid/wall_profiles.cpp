// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Beside boundaries that give it, a velocity is a parabola: its friction and its gradient there are exact for parabolas on cells of any
// height, and so is the flow between plates on four cells.
#include "physics/fluid/wall_profile.hpp"
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr double speed = 0.7; // of the upper wall

double parabola(double y) { return y * (2 + (speed - 2) * y); }

/// Between walls at 0 and 1 along y; each cell is higher than the one below it.
core::Mesh channel()
{
    const auto stretched = [](const Vec3& x) { return Vec3(x.x(), x.y() * (0.6 + 0.4 * x.y()), x.z()); };
    return core::Mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {3, 5, 2}, {1, 1, 1}, {true, false, true}}, stretched), 0, 1);
}

/// Of one component in the only block of a mesh.
struct Component {
    core::ScalarField value, inflow;
    core::VectorField gradient;

    template <class Function>
    Component(const core::Mesh& mesh, Function of)
        : value({"q", "", 1, false}, mesh.own_cells()),
          inflow({"inflow", "", 0, false}, mesh.own_cells()),
          gradient({"gradient", "", 0, false}, mesh.own_cells())
    {
        value.allocate();
        inflow.allocate();
        gradient.allocate();
        const core::Extents n = mesh.geometry(0).cells;
        core::for_each({-1, -1, -1}, {n.ni + 1, n.nj + 1, n.nk + 1},
                       [&](int i, int j, int k) { value.on(0)(i, j, k) = of(mesh.geometry(0).centre(i, j, k)); });
    }
    [[nodiscard]] Vec3 slope(int i, int j, int k) const
    {
        const auto g = gradient.on(0);
        return {g.x(i, j, k), g.y(i, j, k), g.z(i, j, k)};
    }
};

} // namespace

TEST_CASE("friction and gradient beside walls are those of a parabola, on cells of any height")
{
    const core::Mesh mesh = channel();
    const auto& geometry = mesh.geometry(0);
    const auto walls = physics::make_walls(mesh, {{"y_high", {.velocity = Vec3(speed, 0, 0)}}});
    Component u(mesh, [](const Vec3& x) { return parabola(x.y()); });
    const auto q = u.value.on(0);
    const int top = geometry.cells.nj - 1;
    core::for_each({0, 0, 0}, {geometry.cells.ni, 1, geometry.cells.nk}, [&](int i, int, int k) { // mirrored, not continued
        q(i, -1, k) = -q(i, 0, k);
        q(i, top + 1, k) = 2 * speed - q(i, top, k);
    });
    physics::diffusive_inflow(geometry, walls[0], std::as_const(u).value.on(0), {}, {}, {{}, u.inflow.on(0)});
    physics::velocity_gradient(geometry, walls[0], {}, std::as_const(u).value.on(0), u.gradient.on(0));
    const auto y = [&](int j) { return geometry.centre(0, j, 0).y(); };
    const auto slope = [](double at) { return 2 + 2 * (speed - 2) * at; };
    const double area = geometry.area(1, 0, 0, 0).y();
    // Between cells the flux has the slope of the parabola half way between the centres.
    const double low = area * (slope(0.5 * (y(0) + y(1))) - slope(0)), high = area * (slope(1) - slope(0.5 * (y(top - 1) + y(top))));
    constexpr double round_off = 1e-13;
    CHECK(std::abs(u.inflow.on(0)(1, 0, 1) - low) < round_off);
    CHECK(std::abs(u.inflow.on(0)(1, top, 1) - high) < round_off);
    for (const int j : {0, top}) CHECK((u.slope(1, j, 1) - Vec3(0, slope(y(j)), 0)).norm() < round_off);
}

TEST_CASE("gradients of linear velocities stay exact beside walls of a wavy block, its corners included")
{
    const auto wavy = [](const Vec3& x) { return Vec3(x + 0.04 * Vec3(std::sin(6 * x.y()), std::sin(5 * x.z()), std::sin(6 * x.x()))); };
    const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {6, 5, 4}, {1, 1, 1}}, wavy), 0, 1);
    const Vec3 slope(1, -2, 3);
    Component u(mesh, [&](const Vec3& x) { return slope.dot(x); });
    physics::velocity_gradient(mesh.geometry(0), physics::make_walls(mesh, {})[0], {}, std::as_const(u).value.on(0), u.gradient.on(0));
    double worst = 0;
    core::for_each_cell(mesh.geometry(0).cells, [&](int i, int j, int k) { worst = std::max(worst, (u.slope(i, j, k) - slope).norm()); });
    CHECK(worst < 1e-12); // round-off
}

TEST_CASE("four cells between plates give their flow exactly, and friction bears the drive")
{
    for (const auto scheme : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume}) {
        physics::FluidParameters oil;
        oil.density = 1;
        oil.viscosity = 0.5;
        oil.drive = physics::ConstantDrive{Vec3(1, 0, 0)};
        oil.advection = scheme;
        test::FluidRun run(core::make_box({{0, 0, 0}, {1, 1, 1}, {2, 4, 1}, {1, 1, 1}, {true, false, true}}), oil);
        run.start([](const Vec3&) { return Vec3(0, 0, 0); });
        while (run.time() < 8) run.step(0.05); // 8 pi^2 nu = 39: what is left of the start is 1e-17 of it
        const auto exact = [](const Vec3& x) { return Vec3(x.y() * (1 - x.y()), 0, 0); };
        CHECK(run.velocity_error(exact) < 1e-8); // the tolerance of implicit viscosity
        CHECK(std::abs(run.budget().viscosity.x() + run.budget().drive.x()) < 1e-8 * run.budget().drive.x());
    }
}
