// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=300
// Scalars and turbulence in fluid that shares its cells with grains: nothing is made, lost or driven out of its range by grains that
// pass through, and bits do not depend on ranks.
#include "core/comm/reduce.hpp"
#include "tests/support/coupled_run.hpp"
#include <doctest/doctest.h>

using namespace test;

namespace {

io::Scene falling(io::CouplingMode mode, bool turbulent)
{
    CoupledBox box;
    box.blocks = {2, 2, 1};
    box.periodic = {io::Axis::x, io::Axis::z};
    box.gravity = {0, -9.81, 0};
    box.pressure_gradient = 2e3;
    box.mode = mode;
    io::Scene scene = scene_of(box, mode == io::CouplingMode::concurrent ? 60 : 150);
    scene.fluid->scalars = {{"dye", 0.0, 0.0, {}}, {"heat", 1e-6, 0.0, {}}, {"salt", 1e-6, 3.0, {}}};
    if (turbulent) scene.fluid->turbulence = io::TurbulenceKeys{io::TurbulenceModel::k_epsilon, 0.05, 0.3, {}, 0.0};
    return scene;
}

/// Dye and heat of 1 in the lower half.
void colour(io::World& world)
{
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
        for (const std::size_t n : {0, 1})
            core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
                world.scalars()->fields().values[n].on(b)(i, j, k) = world.mesh().geometry(b).centre_y(i, j, k) < 12e-3 ? 1.0 : 0.0;
            });
}

double amount(io::World& world, std::size_t n)
{
    const auto& fields = world.scalars()->fields();
    return core::sum_over_blocks(world.mesh(), world.ranks(), [&](core::LocalBlock b) {
        double sum = 0;
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
            sum += world.mesh().geometry(b).volume(i, j, k) * fields.share.on(b)(i, j, k) * fields.values[n].on(b)(i, j, k);
        });
        return sum;
    });
}

/// Largest of value(block, i, j, k) on all ranks.
template <class Value>
double largest(io::World& world, Value value)
{
    return core::max_over_blocks(world.mesh(), world.ranks(), [&](core::LocalBlock b) {
        double most = -1e300;
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) { most = std::max(most, value(b, i, j, k)); });
        return most;
    });
}

} // namespace

TEST_CASE("grains that fall through a dyed layer leave its amount and its range")
{
    CoupledRun run(falling(io::CouplingMode::pipelined, false));
    colour(run.world());
    run.start({0.1, 0, 0});
    io::World& world = run.world();
    const std::array before{amount(world, 0), amount(world, 1), amount(world, 2)};
    for (int n = 0; n < 60; ++n) run.step();
    const auto& fields = world.scalars()->fields();
    for (std::size_t n = 0; n < 3; ++n) CHECK(std::abs(amount(world, n) / before[n] - 1) < 1e-12); // round-off of 60 steps
    const auto outside = [&](std::size_t n, double low, double high) {
        return largest(world, [&](core::LocalBlock b, int i, int j, int k) {
            const double q = fields.values[n].on(b)(i, j, k);
            return std::max(low - q, q - high);
        });
    };
    CHECK(outside(0, 0, 1) < 1e-13);
    CHECK(outside(1, 0, 1) < 1e-10); // diffusion is solved to 1e-12
    CHECK(outside(2, 3, 3) < 1e-10);
    const double apart = largest(world, [&](core::LocalBlock b, int i, int j, int k) {
        return std::abs(fields.share.on(b)(i, j, k) - world.coupling()->fields().fraction.on(b)(i, j, k));
    });
    const double densest =
        largest(world, [&](core::LocalBlock b, int i, int j, int k) { return 1 - world.coupling()->fields().fraction.on(b)(i, j, k); });
    MESSAGE("carried share and fluid fraction differ by ", apart, " where grains fill up to ", densest);
    CHECK(apart < 1e-6); // the tolerance of the pressure is 1e-8 of what flows through
    CHECK(densest > 0.05);
}

TEST_CASE("turbulence and scalars between grains have the bits of one rank on two, whichever mode couples")
{
    for (const io::CouplingMode mode : every_mode) {
        CoupledRun shared(falling(mode, true), "shuffle:3"), alone(falling(mode, true), "serial", core::Communicator::self());
        for (CoupledRun* run : {&shared, &alone}) {
            colour(run->world());
            run->start({0.3, 0, 0}, {0.5, 0, 0});
        }
        for (int n = 0; n < 10; ++n) {
            shared.step();
            alone.step();
        }
        const core::Mesh &mine = shared.world().mesh(), &all = alone.world().mesh();
        int different = 0, sick = 0;
        for (core::LocalBlock b = 0; b < mine.own_count(); ++b) {
            const core::LocalBlock other = all.local(mine.global(b));
            core::for_each_cell(mine.geometry(b).cells, [&](int i, int j, int k) {
                const auto k_here = shared.world().turbulence()->k().on(b)(i, j, k),
                           epsilon = shared.world().turbulence()->epsilon().on(b)(i, j, k);
                different += k_here != alone.world().turbulence()->k().on(other)(i, j, k);
                different += epsilon != alone.world().turbulence()->epsilon().on(other)(i, j, k);
                sick += !(k_here > 0 && epsilon > 0);
                for (std::size_t n = 0; n < 3; ++n)
                    different += shared.world().scalars()->fields().values[n].on(b)(i, j, k) !=
                                 alone.world().scalars()->fields().values[n].on(other)(i, j, k);
                for (int c = 0; c < 3; ++c)
                    different += shared.world().fluid()->state().velocity.on(b).component(c)(i, j, k) !=
                                 alone.world().fluid()->state().velocity.on(other).component(c)(i, j, k);
            });
        }
        CHECK(different == 0);
        CHECK(sick == 0);
    }
}
