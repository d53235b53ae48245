// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// A prescribed flow of fluid and grains: the flux of the mixture is exact in every mode, and the books of momentum close with the
// gradient that was found.
#include "core/comm/reduce.hpp"
#include "io/run/metric_groups.hpp"
#include "physics/fluid/section_flow.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

io::Scene pipe(const std::string& mode, const std::string& drive)
{
    return small_pipe(drive, "added_mass: on, lift: on, torque: on, mode: " + mode);
}

double mixture_flow(const io::World& world)
{
    const physics::SectionFlow section(world.mesh(), Vec3::UnitX());
    return core::sum_over_blocks(world.mesh(), world.ranks(),
                                 [&](core::LocalBlock b) { return section.through(b, world.fluid()->state().flux.on(b)); });
}

} // namespace

TEST_CASE("in every mode the mixture flows as prescribed at the end of each step, and momentum is explained line by line")
{
    for (const char* mode : {"pipelined", "coarse", "concurrent", "iterated"}) {
        io::World world(pipe(mode, "bulk_velocity: 0.3 m/s, over_time: { frequency: 10 Hz, mean: 1, amplitude: 0.5 }"),
                        core::Communicator::self());
        world.settle(core::SerialTeam());
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        io::MomentumLedger books(world);
        const double area = world.mesh().total_volume() / 24e-3;
        double defect = 0, exchange = 0, flow = 0, largest = 0, correction = 0;
        for (int step = 0; step < 60; ++step) {
            world.step(*executor);
            books.update();
            defect = std::max(defect, books.defect());
            exchange = std::max(exchange, books.exchange_defect());
            const double wanted = 0.3 * area * (1 + 0.5 * std::cos(2 * std::numbers::pi * 10 * world.time()));
            flow = std::max(flow, std::abs(mixture_flow(world) / wanted - 1));
            const auto& drive = world.clock().drive;
            if (step > 2) correction = std::max(correction, std::abs(drive.correction));
            if (step > 2) largest = std::max(largest, std::abs(drive.expected + drive.correction));
        }
        std::printf("%-10s flow %.1e, momentum %.1e, exchange %.1e; acceleration up to %.3g, corrected by up to %.2g m/s2\n", mode, flow,
                    defect, exchange, largest, correction);
        CHECK(flow < 1e-9);      // what the solver leaves of the divergence, 1e-8 of a cell's flux, adds up at random
        CHECK(defect < 1e-9);    // as with a gradient that is given: the solver's share of the viscous change
        CHECK(exchange < 1e-12); // round-off
    }
}

TEST_CASE("a prescribed flow of nothing keeps fluid without walls at rest while grains that sink push it")
{
    CoupledBox box;
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.gravity = Vec3(-9.81, 0, 0);
    io::Scene scene = scene_of(box, 100);
    scene.fluid->drive = io::Drive{};
    scene.fluid->drive->bulk_velocity = 0.0;
    CoupledRun run(scene);
    run.go_on();
    for (int n = 0; n < 200; ++n) run.step();
    // Nothing but the drive carries the weight of the grains in the fluid: in the mean of the last steps, when they sink at a
    // constant speed, it is the drop that the whole mixture needs, their excess weight per volume.
    double mean = 0;
    for (int n = 0; n < 100; ++n) {
        run.step();
        const auto& drive = run.world().clock().drive;
        mean += (drive.expected + drive.correction) / 100;
    }
    const double weight = 9.81 * run.solid_volume() / box.size.prod(); // density ratio 2
    MESSAGE("drive ", mean, " of ", weight, " m/s2");
    CHECK(mean == test::relative(weight).epsilon(0.05)); // what speeds still change
    CHECK(std::abs(mixture_flow(run.world())) < 1e-12);
}

TEST_CASE("a step of a prescribed flow is repeated to the same bits after the state was read back")
{
    const auto speeds = [](io::World& world) {
        std::vector<double> all;
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            for (double u : world.fluid()->state().velocity.data(b, 0)) all.push_back(u);
        return all;
    };
    io::World world(pipe("pipelined", "flow_rate: 0.1 l/s"), core::Communicator::self());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    for (int n = 0; n < 5; ++n) world.step(*executor);
    io::StateCopy copy;
    copy.take(world);
    world.step(*executor);
    const auto first = speeds(world);
    copy.put_back(world);
    tasks::run(world.ranks(), core::SerialTeam(), [&](tasks::Lane& lane) { return world.coupling()->initialise(lane); });
    world.step(*executor);
    CHECK(speeds(world) == first);
}
