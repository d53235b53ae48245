// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// An exact flow in three dimensions that decays, every term of the equations at work and its velocity given on all sides: on a box, on
// bent grids, and on blocks whose points do not match (NUMERICS C1.1).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using std::numbers::pi;

constexpr double a = pi / 4, d = pi / 2, viscosity = 0.05, density = 1000;
constexpr double decay = viscosity * d * d; ///< [1/s]

/// Velocity at t = 0; later times exp(-decay t).
/// @source  Ethier & Steinman (1994), Int. J. Numer. Meth. Fluids 19, 369, eqs (14)-(16).
Vec3 velocity(const Vec3& x)
{
    const auto component = [&](int i) {
        const double p = x[i], q = x[(i + 1) % 3], r = x[(i + 2) % 3];
        return -a * (std::exp(a * p) * std::sin(a * q + d * r) + std::exp(a * r) * std::cos(a * p + d * q));
    };
    return {component(0), component(1), component(2)};
}

/// The same, eq. (17); later times exp(-2 decay t).
double pressure(const Vec3& x)
{
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double p = x[i], q = x[(i + 1) % 3], r = x[(i + 2) % 3];
        sum += std::exp(2 * a * p) + 2 * std::sin(a * p + d * q) * std::cos(a * r + d * p) * std::exp(a * (q + r));
    }
    return -0.5 * density * a * a * sum;
}

physics::TimeCourse decaying(double until)
{
    constexpr int points = 200; // third order between them: 1e-9
    std::vector<physics::TableCourse::Point> table;
    for (int n = 0; n <= points; ++n) table.push_back({until * n / points, std::exp(-decay * until * n / points)});
    return physics::TableCourse(table, physics::TableCourse::Between::cubic, physics::TableCourse::Beyond::hold);
}

/// Velocity on all sides; what faces of finite size make of its flux, which is not quite nothing, leaves evenly through all of them.
physics::BoundaryConditions boundaries(const core::MultiBlock& grid, double until)
{
    const core::Mesh mesh(grid, 0, 1);
    const auto given = [&](double inward) {
        physics::BoundaryConditions all;
        for (const core::Boundary& side : mesh.topology().boundaries)
            all[side.name] = {.kind = physics::BoundaryKind::inflow,
                              .profile = [=](const Vec3& x) { return Vec3(velocity(x) - inward * x); },
                              .course = decaying(until)};
        return all;
    };
    const auto net = [&](double inward) {
        const auto walls = physics::make_walls(mesh, given(inward));
        double sum = 0;
        for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) sum += physics::given_flux(mesh.geometry(b), walls[std::size_t(b)]).net;
        return sum;
    };
    const double one = net(0), other = net(1);
    return given(one / (one - other));
}

struct Errors {
    double velocity, pressure;
};

Errors errors(const core::MultiBlock& grid, int cells)
{
    constexpr double until = 0.5;
    physics::FluidParameters p;
    p.viscosity = viscosity;
    p.tolerances = {.pressure = 1e-10, .viscosity = 1e-10};
    p.boundaries = boundaries(grid, until);
    test::FluidRun run(grid, p);
    run.start(velocity, pressure);
    run.fluid().state().clock.steps_since_jump = 2; // the exact start is no jump
    const int steps = 2 * cells;                    // the fastest fluid, 3.4 at most, crosses 0.43 cells of an even box
    for (int n = 0; n < steps; ++n) run.step(until / steps);
    const double share = std::exp(-decay * until), middle = std::exp(-2 * decay * (until - 0.5 * until / steps));
    const Errors e{run.velocity_error([&](const Vec3& x) { return Vec3(share * velocity(x)); }),
                   run.pressure_error([&](const Vec3& x) { return middle * pressure(x); }) / density};
    MESSAGE(cells, " cells along each side: velocity ", e.velocity, ", pressure ", e.pressure);
    return e;
}

const core::Box whole(int n) { return {{-1, -1, -1}, {1, 1, 1}, {n, n, n}, {2, 1, 1}, {}}; }
Vec3 bent(const Vec3& x)
{
    const Vec3 wave(std::sin(2 * x.y()) * std::cos(x.z()), std::sin(2 * x.x()), std::sin(x.x() + x.y()));
    return x + 0.08 * wave;
}

void check_second_order(const Errors& coarse, const Errors& fine)
{
    CHECK(std::log2(coarse.velocity / fine.velocity) > 1.8);
    CHECK(std::log2(coarse.pressure / fine.pressure) > 1.5); // NUMERICS C1.2 asks as much of pressures
}

} // namespace

TEST_CASE("a decaying flow in three dimensions, to second order on a box")
{
    check_second_order(errors(core::make_box(whole(12)), 12), errors(core::make_box(whole(24)), 24));
}

TEST_CASE("a decaying flow in three dimensions, to second order on a bent grid")
{
    check_second_order(errors(core::make_box(whole(12), bent), 12), errors(core::make_box(whole(24), bent), 24));
}

TEST_CASE("a decaying flow in three dimensions, to second order on bent blocks with twice and three halves as many points on one side")
{
    const auto grid = [](int n) {
        const core::Box low{{-1, -1, -1}, {0, 1, 1}, {n / 2, n, n}, {1, 1, 1}, {}};
        const core::Box high{{0, -1, -1}, {1, 1, 1}, {n / 2, 2 * n, 3 * n / 2}, {1, 1, 1}, {}};
        return test::joined({low, high}, {}, bent);
    };
    check_second_order(errors(grid(8), 12), errors(grid(16), 24));
}
