// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grains that feel a fluid which does not feel them: the fluid has the bits of a fluid alone, a grain follows its equation of motion at
// second order in time, and two-way coupling tends to the same as the grain gets small.
// ctest: timeout=120
#include "io/run/one_way_books.hpp"
#include "physics/coupling/drag.hpp"
#include "tasks/overlap.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <sstream>

using namespace test;

namespace {

constexpr double pi = std::numbers::pi;

io::Scene one_way(io::Scene scene)
{
    scene.coupling->feedback = io::Feedback::one_way;
    scene.coupling->mode = io::CouplingMode::automatic;
    return scene;
}

std::vector<double> flow_of(io::World& world)
{
    std::vector<double> all;
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b) {
        const auto u = world.fluid()->state().velocity.on(b);
        const auto p = world.fluid()->state().pressure.on(b);
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
            for (int c = 0; c < 3; ++c) all.push_back(u.component(c)(i, j, k));
            all.push_back(p(i, j, k));
        });
    }
    return all;
}

std::vector<double> flow_after(const io::Scene& scene, int steps)
{
    io::World world(scene, core::Communicator::self());
    world.settle(core::SerialTeam());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    for (int n = 0; n < steps; ++n) world.step(*executor);
    return flow_of(world);
}

/// A channel in which grains sink, with whatever else the fluid has.
std::string channel(const std::string& fluid, bool grains)
{
    return "name: channel\n"
           "grid: { box: { size: [24 mm, 16 mm, 16 mm], cells: [12, 8, 8], blocks: [2, 1, 1] }, periodic: [x] }\n"
           "fluid: { water: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }, " +
           fluid + " }\ngravity: { direction: -y }\n" +
           (grains ? "particles:\n  - { name: grains, count: 60, diameter: 2 mm, density: 2000 kg/m3 }\n"
                     "contact: { stiffness: 500 N/m }\ncoupling: { feedback: one_way, lift: on }\n"
                   : "") +
           "run: { until: 1 s, time_step: 1 ms }\n";
}

} // namespace

TEST_CASE("a fluid that does not feel its grains has the bits of a fluid alone")
{
    for (const char* fluid : {"drive: { pressure_gradient: 100 Pa/m }", "drive: { bulk_velocity: 0.1 m/s }",
                              "advection: finite_volume, drive: { pressure_gradient: 100 Pa/m, frequency: 20 Hz }",
                              "drive: { pressure_gradient: 100 Pa/m }, turbulence: { model: k-epsilon, speed: 0.1 m/s }",
                              "drive: { pressure_gradient: 100 Pa/m }, scalars: [ { name: dye, diffusivity: 1e-6 m2/s, initial: 1 } ]"}) {
        CAPTURE(fluid);
        const io::Scene with = scene_from_text(channel(fluid, true));
        io::Scene without = scene_from_text(channel(fluid, false));
        without.run.time_step = io::World(with, core::Communicator::self()).next_step(); // a whole number of sub-steps
        CHECK(flow_after(with, 25) == flow_after(without, 25));
    }
}

TEST_CASE("what depends on grains that the fluid feels is refused beside one_way")
{
    for (const auto& [key, word] :
         {std::pair{"mode", "pipelined"}, {"own_disturbance", "on"}, {"size_mixture", "on"}, {"added_mass", "zuber"}}) {
        std::string text = channel("drive: { pressure_gradient: 100 Pa/m }", true);
        text.replace(text.find("lift: on"), 8, std::string(key) + ": " + word);
        const io::SceneReading reading = io::read_scene_text("scene.yaml", text);
        CHECK(reading.problems->text().find(std::string("'feedback: one_way' excludes '") + key) != std::string::npos);
    }
}

TEST_CASE("nothing is summed over grains where the fluid does not feel them, and the fluid need not wait for them")
{
    io::World world(scene_from_text(channel("drive: { pressure_gradient: 100 Pa/m }", true)), core::Communicator::self());
    const tasks::Plan& plan = world.compile();
    std::ostringstream report;
    report << plan.describe();
    for (const char* stage : {"sum over grains", "fluid fraction", "ledger", "predict with grains"})
        CHECK(report.str().find(stage) == std::string::npos);
    const auto beside = tasks::stages_beside(plan, "move grains");
    for (const char* stage : {"predict velocity", "solve pressure", "correct velocity"})
        CHECK(std::ranges::find(beside, stage) != beside.end());
}

TEST_CASE("a grain in a fluid that swings follows its equation of motion, at second order in time")
{
    // (m + m_a) dv/dt = K (u - v) + (rho V + m_a) du/dt + (m - rho V) g, u = A / w sin w t
    constexpr double d = 1e-3, ratio = 2.5, nu = 1e-5, rho = 1000, amplitude = 2.0, w = 2 * pi * 10, volume = pi / 6 * d * d * d;
    const Vec3 gravity(0, 0, -3);
    CoupledBox box;
    box.size = 16e-3 * Vec3::Ones();
    box.cells = {4, 4, 4};
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.diameter = d;
    box.density_ratio = ratio;
    box.viscosity = nu;
    box.pressure_gradient = amplitude * rho;
    box.gravity = gravity;
    box.stiffness = 1.0; // nobody to meet: it decides how long sub-steps are
    io::Scene scene = one_way(scene_of(box, 1));
    scene.fluid->drive->frequency = w / (2 * pi);
    const double sub_step = CoupledRun(scene).world().grains()->step();
    constexpr int sub_steps = 8 * 64;
    const auto rate = [&](double t, const Vec3& v) -> Vec3 {
        const Vec3 slip = Vec3(amplitude / w * std::sin(w * t), 0, 0) - v;
        const double drag = physics::drag_di_felice({slip.norm(), 1.0, d, rho, rho * nu}), mass = ratio * rho * volume;
        const Vec3 push = 1.5 * rho * volume * Vec3(amplitude * std::cos(w * t), 0, 0) + (mass - rho * volume) * gravity;
        return (drag * slip + push) / (mass + 0.5 * rho * volume);
    };
    Vec3 exact = Vec3::Zero();
    constexpr int fine = 20000;
    for (int n = 0; n < fine; ++n) { // Runge and Kutta's fourth order
        const double h = sub_steps * sub_step / fine, t = n * h;
        const Vec3 a = rate(t, exact), b = rate(t + h / 2, exact + h / 2 * a), c = rate(t + h / 2, exact + h / 2 * b),
                   e = rate(t + h, exact + h * c);
        exact += h / 6 * (a + 2 * b + 2 * c + e);
    }
    std::vector<double> errors;
    for (const int parts : {32, 16, 8}) {
        scene.run.time_step = (parts + 1e-6) * sub_step;
        CoupledRun run(scene);
        run.place({Vec3(7.1e-3, 6.2e-3, 8.3e-3)});
        run.start();
        io::OneWayBooks books(run.world());
        for (int n = 0; n < sub_steps / parts; ++n) {
            const Vec3 before = books.lines().momentum + books.lines().owed;
            run.step();
            books.update();
            const auto& l = books.lines();
            const Vec3 left = l.momentum + l.owed - before - (l.drive + l.weight + l.contact + l.exchange);
            CHECK(left.norm() < 1e-12 * ratio * rho * volume * exact.norm()); // round-off
        }
        errors.push_back((run.grains().velocity_of(0) - exact).norm() / exact.norm());
    }
    std::printf("grain in a swinging fluid: errors %.1e %.1e %.1e, orders %.2f %.2f\n", errors[0], errors[1], errors[2],
                std::log2(errors[0] / errors[1]), std::log2(errors[1] / errors[2]));
    CHECK(std::log2(errors[1] / errors[2]) > 1.8);
    CHECK(errors[2] < 2e-3); // of steps of a fortieth of the time that slip decays in
}

TEST_CASE("coupling both ways tends to one way as the loading vanishes")
{
    // What a grain does to the fluid that it samples is 0.40 d / b of its slip in creeping flow: half as much for half the diameter.
    std::vector<double> differences;
    for (const double d : {0.8e-3, 0.4e-3, 0.2e-3}) {
        CoupledBox box;
        box.periodic = {io::Axis::x, io::Axis::z};
        box.diameter = d;
        box.viscosity = 1e-3;                         // creeping
        box.gravity = {0, -9.81 / (d * d) * 1e-6, 0}; // the same slip for all
        box.stiffness = 100;
        io::Scene scene = scene_of(box, 1);
        scene.coupling->filter = {4e-3, false};
        const auto velocity = [&](const io::Scene& s) {
            CoupledRun run(s);
            run.place({Vec3(7.1e-3, 14.2e-3, 8.3e-3)});
            run.start();
            for (int n = 0; n < 60; ++n) run.step();
            return run.grains().velocity_of(0).y();
        };
        const double both = velocity(scene), one = velocity(one_way(scene));
        differences.push_back(std::abs(both / one - 1));
        std::printf("d %.1e m: two ways %.6e, one way %.6e m/s, apart %.2e\n", d, both, one, differences.back());
    }
    CHECK(differences[2] < 0.05);
    CHECK(differences[1] / differences[2] == test::relative(2.0).epsilon(0.15));
}
