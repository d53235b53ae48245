// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A bed that contacts hold, not its mass: squeezed between two walls. Its drag is all there at once.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

constexpr double diameter = 5e-5;

/// Face-centred cubes from wall to wall, a thousandth closer than touching; the walls push as hard as four neighbours do.
struct Squeezed {
    double edge = std::sqrt(2.0) * 0.999 * diameter, clear = (0.5 - std::sqrt(8.0) * 0.001) * diameter;
    core::Index3 count{2, 2, 2};
    [[nodiscard]] Vec3 size() const { return edge * Vec3(count.i, count.j - 0.5, count.k) + Vec3(0, 2 * clear, 0); }
    [[nodiscard]] std::vector<Vec3> places() const
    {
        std::vector<Vec3> all;
        core::for_each({0, 0, 0}, count, [&](int i, int j, int k) {
            for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0.5, 0.5)})
                all.push_back(Vec3(0.25 * edge, clear, 0.25 * edge) + edge * (Vec3(i, j, k) + corner));
        });
        return all;
    }
};

/// The springs must be so stiff that a grain moves little, as its drag leans on it, against the water that would pass it in
/// the meantime: K / (k dt) is at most 0.005 here. Else the bed is not locked: it gives way, and the water goes with it.
struct Case {
    double viscosity, stiffness; ///< [m2/s], [N/m]
    io::CouplingMode mode;
};

} // namespace

TEST_CASE("a locked bed carries the pressure gradient within three steps of switching it on, M b to 1e5")
{
    const Squeezed bed;
    for (const Case& c : {Case{2e-7, 50, io::CouplingMode::pipelined}, Case{1e-6, 50, io::CouplingMode::pipelined},
                          Case{1e-6, 50, io::CouplingMode::automatic}, Case{3e-5, 50, io::CouplingMode::automatic},
                          Case{1e-3, 5e3, io::CouplingMode::automatic}}) {
        CoupledBox box;
        box.size = bed.size();
        box.cells = {3, 3, 3};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.diameter = diameter;
        box.density_ratio = 2.65;
        box.viscosity = c.viscosity;
        box.pressure_gradient = 1e3;
        box.stiffness = c.stiffness;
        box.drag = io::DragLaw::seed;
        box.mode = c.mode;
        CoupledRun run(box, 1);
        run.place(bed.places());
        run.start();
        const auto superficial = [&] {
            return run.integral([&](core::LocalBlock b, int i, int j, int k) {
                return run.world().coupling()->fields().fraction.on(b)(i, j, k) * run.world().fluid()->state().velocity.on(b).x(i, j, k);
            }) / box.size.prod();
        };
        std::vector<double> flow;
        for (int n = 0; n < 6; ++n) {
            run.step();
            flow.push_back(superficial());
        }
        const double solid = run.solid_volume() / box.size.prod(), phi = 1 - solid, mu = 1000 * box.viscosity;
        const double viscous = 150 * solid * solid * mu / (std::pow(phi, 3) * diameter * diameter);
        const double inertial = 1.75 * solid * 1000 / (std::pow(phi, 3) * diameter), gradient = box.pressure_gradient;
        const double ergun = 2 * gradient / (viscous + std::sqrt(viscous * viscous + 4 * inertial * gradient));
        const auto numbers = run.world().coupling()->stability(box.dt);
        std::printf("locked, M b %.0f: after 1, 2, 3, 6 steps %.4f %.4f %.4f %.4f of Ergun; grains %.0e of it; %s\n",
                    numbers.stiffness * numbers.loading, flow[0] / ergun, flow[1] / ergun, flow[2] / ergun, flow[5] / ergun,
                    run.grain_deviation() / ergun, run.world().mode_reason().c_str());
        // NUMERICS D 3. The walls take up to 0.5 % of the gradient.
        CHECK(std::abs(flow[2] / ergun - 1) < 0.01);
        CHECK(std::abs(flow[5] / ergun - 1) < 0.01);
        CHECK(run.grain_deviation() < 1e-3 * ergun);
    }
}
