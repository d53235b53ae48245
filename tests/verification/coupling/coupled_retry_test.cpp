// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A step that fails is tried again with half the time, and then is the step that half the time would have made.
#include "core/base/error.hpp"
#include "tests/support/coupled_run.hpp"
#include <doctest/doctest.h>

using namespace test;

namespace {

/// Makes the whole step, spoils the state as a failure in its middle may, and fails; as often as it is told.
class FailingExecutor final : public tasks::Executor {
public:
    FailingExecutor(io::World& world, const tasks::Plan& plan) : world_(world), inner_(tasks::make_executor({.kind = "serial"}, plan)) {}
    void run_step(std::int64_t step) override
    {
        inner_->run_step(step);
        if (failures == 0) return;
        --failures;
        for (double& u : world_.fluid()->state().velocity.data(0, 0)) u += 1.0;
        for (double& v : world_.grains()->particles.velocity[1]) v -= 1.0;
        throw core::NumericsError("the step fails on purpose");
    }
    [[nodiscard]] std::string name() const override { return "failing"; }
    int failures = 0;

private:
    io::World& world_;
    std::unique_ptr<tasks::Executor> inner_;
};

io::Scene falling()
{
    CoupledBox box;
    box.gravity = {0, -9.81, 0};
    box.periodic = {io::Axis::x, io::Axis::z};
    io::Scene scene = scene_of(box, 100);
    scene.run.until = 0.4;
    scene.run.time_step.reset();
    scene.run.limits.cfl = 0.5;
    return scene;
}

std::vector<double> state_of(io::World& world)
{
    std::vector<double> all;
    const auto& state = world.fluid()->state();
    core::for_each_cell(world.mesh().geometry(0).cells, [&](int i, int j, int k) {
        const auto u = state.velocity.on(0);
        all.insert(all.end(), {u.x(i, j, k), u.y(i, j, k), u.z(i, j, k), state.pressure.on(0)(i, j, k),
                               world.coupling()->fields().fraction.on(0)(i, j, k)});
    });
    const core::ParticleSet& p = world.grains()->particles;
    for (int g = 0; g < p.owned; ++g)
        for (std::size_t a = 0; a < 3; ++a)
            all.insert(all.end(), {p.position[a][std::size_t(g)], p.velocity[a][std::size_t(g)], p.spin[a][std::size_t(g)]});
    all.insert(all.end(), {world.time(), world.clock().dt, double(world.clock().step), double(world.sub_steps())});
    return all;
}

} // namespace

TEST_CASE("a step that failed and was tried again has the bits of one that was as short from the start")
{
    constexpr int before = 5, after = 5;
    const auto run = [](int failures, bool short_from_start) {
        io::Scene scene = falling();
        io::World world(scene, core::Communicator::self());
        FailingExecutor executor(world, world.compile());
        for (int n = 0; n < before; ++n) world.step(executor);
        std::vector<std::string> warnings;
        if (short_from_start) {
            world.shorten_next_step(std::pow(0.5, failures));
        } else {
            executor.failures = failures;
        }
        world.step(executor);
        warnings = world.take_warnings();
        CHECK(int(warnings.size()) == (short_from_start ? 0 : failures));
        for (int n = 0; n < after; ++n) world.step(executor);
        return state_of(world);
    };
    for (const int failures : {1, 2}) CHECK(run(failures, false) == run(failures, true));
}

TEST_CASE("a step that fails for the third time, or whose length the scene fixes, is given up with the state before it")
{
    for (const bool fixed : {false, true}) {
        io::Scene scene = falling();
        if (fixed) scene.run.time_step = 1e-3;
        io::World world(scene, core::Communicator::self());
        FailingExecutor executor(world, world.compile());
        for (int n = 0; n < 3; ++n) world.step(executor);
        const auto kept = state_of(world);
        const double time = world.time();
        executor.failures = 3;
        CHECK_THROWS_AS(world.step(executor), core::NumericsError);
        CHECK(world.time() == time);
        auto now = state_of(world);
        now.resize(kept.size() - 4);
        CHECK(now == std::vector<double>(kept.begin(), kept.end() - 4)); // all but the clock's dt and the sub-steps
    }
}
