// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The logarithmic layer as the k-epsilon model itself has it, without walls (NUMERICS U9): friction is the same at every height,
// u = u_tau ln(y) / kappa, k = u_tau^2 / C_mu^(1/2), epsilon = u_tau^3 / (kappa y) with the kappa that the model's constants imply.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

const double kappa =
    std::sqrt(std::sqrt(physics::k_epsilon.c_mu) * (physics::k_epsilon.c_2 - physics::k_epsilon.c_1) * physics::k_epsilon.sigma_epsilon);

/// Friction speed 1 m/s, heights from 0.5 to 2.5 m; the flow is found between 1 and 2 m and given above and below.
struct Layer {
    static double u(double y) { return std::log(y) / kappa; }
    static double k() { return 1 / std::sqrt(physics::k_epsilon.c_mu); }
    static double epsilon(double y) { return 1 / (kappa * y); }
    static bool found(double y) { return y > 1 && y < 2; }
};

struct Errors {
    double u = 0, k = 0, epsilon = 0;
};

void give(test::FluidRun& run, bool everywhere)
{
    auto& state = run.fluid().state();
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
        core::for_each_cell(run.mesh().geometry(b).cells, [&](int i, int j, int k) {
            const double y = run.centre(b, i, j, k).y();
            if (!everywhere && Layer::found(y)) return;
            state.velocity.on(b).x(i, j, k) = Layer::u(y);
            run.turbulence().k().on(b)(i, j, k) = Layer::k();
            run.turbulence().epsilon().on(b)(i, j, k) = Layer::epsilon(y);
        });
}

/// Largest errors over the values in the middle of the layer, once what the grid makes of it has settled.
Errors settled(int cells)
{
    physics::FluidParameters fluid;
    fluid.viscosity = 1e-5; // a hundred-thousandth of that of turbulence
    for (const char* side : {"y_low", "y_high"}) fluid.boundaries[side] = {.kind = physics::BoundaryKind::slip};
    const core::Box box{{0, 0.5, 0}, {1, 2.5, 1}, {1, cells, 1}, {1, 2, 1}, {true, false, true}};
    const test::Carried carried{.turbulence = physics::TurbulenceParameters{{1, 1}, {}, 0}};
    test::FluidRun run(core::make_box(box), fluid, {.kind = "serial"}, core::Communicator::self(), carried);
    run.start([](const Vec3& x) { return Vec3(Layer::u(x.y()), 0, 0); });
    give(run, true);
    // In a step k and epsilon spread by 0.05 m, a tenth of the width of what is given; 5 s are three times what the middle needs.
    for (int n = 0; n < 1000; ++n) {
        run.step(0.005);
        give(run, false);
    }
    const auto worst = [&](const std::function<double(core::LocalBlock, int, int, int, double)>& error) {
        return run.largest([&](core::LocalBlock b, int i, int j, int k) {
            const double y = run.centre(b, i, j, k).y();
            return Layer::found(y) ? error(b, i, j, k, y) : 0.0;
        });
    };
    Errors e;
    e.u = worst([&](core::LocalBlock b, int i, int j, int k, double y) { return kappa * (run.velocity(b, i, j, k).x() - Layer::u(y)); });
    e.k = worst([&](core::LocalBlock b, int i, int j, int k, double) { return run.turbulence().k().on(b)(i, j, k) / Layer::k() - 1; });
    e.epsilon = worst([&](core::LocalBlock b, int i, int j, int k, double y) {
        return run.turbulence().epsilon().on(b)(i, j, k) / Layer::epsilon(y) - 1;
    });
    return e;
}

} // namespace

TEST_CASE("the logarithmic layer of the model is found to second order")
{
    CHECK(kappa == doctest::Approx(0.43267).epsilon(1e-5)); // NUMERICS A4
    const Errors coarse = settled(16), middle = settled(32), fine = settled(64);
    // From differences between grids: what viscosity and the given edges leave, 1e-5, is the same on all of them.
    const auto order = [&](double Errors::*part) { return std::log2((coarse.*part - middle.*part) / (middle.*part - fine.*part)); };
    for (const Errors& e : {coarse, middle, fine}) MESSAGE("errors of u, k, epsilon: ", e.u, ", ", e.k, ", ", e.epsilon);
    MESSAGE("orders ", order(&Errors::u), ", ", order(&Errors::k), ", ", order(&Errors::epsilon));
    for (const auto part : {&Errors::u, &Errors::k, &Errors::epsilon}) CHECK(order(part) > 1.9);
    CHECK(fine.epsilon < 2e-4); // 32 cells from y = 1 to y = 2: (h / y)^2 / 5
}
