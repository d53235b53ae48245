// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Grains and fluid through a side of blocks whose points do not match: momentum and volume close, and a grain that crosses it does not
// notice (NUMERICS B8, C6).
#include "tests/support/coupled_run.hpp"
#include "tests/support/joined_scene.hpp"
#include <cstdio>

namespace {

using core::Vec3;

/// Two boxes of 8 mm that meet at x = 8 mm, one above the other if turned.
std::vector<core::Box> across(core::Extents first, core::Extents second)
{
    return {{{0, 0, 0}, {8e-3, 16e-3, 8e-3}, first, {1, 1, 1}, {}}, {{8e-3, 0, 0}, {16e-3, 16e-3, 8e-3}, second, {1, 1, 1}, {}}};
}

/// A grain that sinks along y from one box of cells into another, periodic beside it: its speed at each step.
struct Sinking {
    std::vector<double> height, speed; ///< [m, m/s]
};

Sinking sink(core::Extents lower, core::Extents upper)
{
    const double side = 12e-3, middle = 12e-3, top = 24e-3;
    const test::BoxesFile file(core::Communicator::self(), {{{0, 0, 0}, {side, middle, side}, lower, {1, 1, 1}, {}},
                                                            {{0, middle, 0}, {side, top, side}, upper, {1, 1, 1}, {}}});
    const io::Scene scene = test::scene_from_text("name: grain through a side\n" + file.grid("x, z") + R"(fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
gravity: { direction: -y }
particles: [ { name: ball, count: 1, diameter: 1 mm, density: 2500 kg/m3 } ]
contact: { stiffness: 500 N/m, restitution: 0.6, friction: 0.4 }
coupling: { filter: 2 d, own_disturbance: on }
run: { until: 1 s, time_step: 1 ms }
)");
    test::CoupledRun run(scene, "serial", core::Communicator::self());
    run.place({{5.3e-3, 20e-3, 6.9e-3}});
    run.start();
    Sinking found;
    while (run.grains().position_of(0).y() > 5e-3) {
        run.step();
        found.height.push_back(run.grains().position_of(0).y());
        found.speed.push_back(-run.grains().velocity_of(0).y());
    }
    return found;
}

} // namespace

TEST_CASE("a bed across sides whose points do not match keeps momentum and volume, whichever mode couples")
{
    const test::BoxesFile file(core::Communicator::self(), across({6, 12, 6}, {9, 16, 9}));
    for (const std::string& mode : {std::string("pipelined"), std::string("iterated")}) {
        io::World world(test::bed_across_a_side(file, mode), core::Communicator::self());
        world.settle(core::SerialTeam());
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        io::MomentumLedger books(world);
        double defect = 0, exchange = 0, volume = 0, least = 1, most = 0;
        for (int step = 0; step < 30; ++step) {
            world.step(*executor);
            books.update();
            defect = std::max(defect, books.defect());
            exchange = std::max(exchange, books.exchange_defect());
            double solid = 0, spheres = 0;
            for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
                core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
                    const double c = 1 - world.coupling()->fields().fraction.on(b)(i, j, k);
                    solid += world.mesh().geometry(b).volume(i, j, k) * c;
                    least = std::min(least, c);
                    most = std::max(most, c);
                });
            const auto& grains = world.grains()->particles;
            for (int g = 0; g < grains.owned; ++g) spheres += 4.0 / 3.0 * std::numbers::pi * std::pow(grains.radius[std::size_t(g)], 3);
            volume = std::max(volume, std::abs(solid / spheres - 1));
        }
        std::printf("%s: unexplained %.1e, exchange %.1e, volume %.1e; solid fraction %.1e to %.2f\n", mode.c_str(), defect, exchange,
                    volume, least, most);
        CHECK(defect < 1e-9); // the solver's share of the viscous change, as without such sides
        CHECK(exchange < 1e-12);
        CHECK(volume < 1e-12);
        CHECK(least > -1e-3); // what is deposited is positive; the filter's polynomial undershoots a little
        CHECK(most > 0.3);
    }
}

TEST_CASE("a grain that sinks through a side whose points do not match feels no step, and is as fast as on a matching grid")
{
    const Sinking matching = sink({12, 12, 12}, {12, 12, 12});
    const std::vector<std::pair<core::Extents, core::Extents>> ratios{
        {{12, 12, 12}, {6, 6, 6}}, {{6, 6, 6}, {12, 12, 12}}, {{12, 12, 12}, {8, 8, 8}}};
    for (const auto& [lower, upper] : ratios) {
        const Sinking joined = sink(lower, upper);
        double jump = 0, fastest = 0, difference = 0;
        for (std::size_t n = 1; n < joined.speed.size(); ++n) {
            if (std::abs(joined.height[n] - 12e-3) > 3e-3) continue;
            fastest = std::max(fastest, joined.speed[n]);
            // Net force over the weight, gravity less buoyancy: of 1.5 parts in 2.5 of g.
            const auto force = [&](std::size_t m) { return (joined.speed[m] - joined.speed[m - 1]) / (1e-3 * 0.6 * 9.81); };
            jump = std::max(jump, std::abs(force(n) - force(n - 1)));
        }
        const std::size_t steps = std::min(joined.speed.size(), matching.speed.size());
        for (std::size_t n = steps / 2; n < steps; ++n)
            difference = std::max(difference, std::abs(joined.speed[n] / matching.speed[n] - 1));
        std::printf("%d above %d: %.4f m/s, largest change of force in a step %.2e of the weight, speed off by %.2e\n", upper.ni, lower.ni,
                    fastest, jump, difference);
        CHECK(jump < 0.01);
        CHECK(difference < 0.02);
    }
}
