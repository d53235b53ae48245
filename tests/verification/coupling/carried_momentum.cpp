// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Finite-volume advection beside grains: all momentum is accounted for to round-off, in every mode and across sides whose points do not
// match; grains that move with a uniform flow do not disturb it; a bed lets through what its law says.
#include "physics/coupling/drag.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/joined_scene.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>

namespace {

using core::Vec3;

io::Scene by_finite_volumes(io::Scene scene)
{
    scene.fluid->advection = io::AdvectionScheme::finite_volume;
    return scene;
}

/// Largest of each over the steps: what no line of the books explains, what advection made, what it would have made without the ledger's
/// part, what grains and fluid disagree by, and what flows through boundaries [N s].
struct Closing {
    double unexplained = 0, made = 0, owed = 0, exchange = 0, through = 0;
};

Closing close_books(const io::Scene& scene, int steps)
{
    io::World world(by_finite_volumes(scene), core::Communicator::self());
    world.settle(core::SerialTeam());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    io::MomentumLedger books(world);
    Closing closing;
    for (int step = 0; step < steps; ++step) {
        world.step(*executor);
        books.update();
        double largest = books.totals().sum().norm();
        for (const auto& line : io::MomentumImpulses::outer_lines()) largest = std::max(largest, (books.impulses().*line.impulse).norm());
        Vec3 owed = Vec3::Zero();
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            owed += physics::volume_sum(world.mesh().geometry(b), world.coupling()->transport().owed.on(b));
        closing.unexplained = std::max(closing.unexplained, books.defect());
        closing.exchange = std::max(closing.exchange, books.exchange_defect());
        closing.through = std::max(closing.through, books.impulses().through.norm());
        closing.made = std::max(closing.made, books.impulses().advection.norm() / largest);
        closing.owed = std::max(closing.owed, owed.norm() / largest);
    }
    std::printf("unexplained %.1e, made by advection %.1e, owed for it %.1e, exchange %.1e\n", closing.unexplained, closing.made,
                closing.owed, closing.exchange);
    return closing;
}

void check(const Closing& closing)
{
    CHECK(closing.made < 1e-13);       // rounding of some thousand cells
    CHECK(closing.unexplained < 1e-9); // the solver's share of the viscous change, 1e-8 of it
    CHECK(closing.exchange < 1e-12);
    CHECK(closing.owed > 1e-9); // it is not for want of anything to account for
}

} // namespace

TEST_CASE("finite volumes make no momentum beside grains, whichever mode couples")
{
    for (const char* mode : {"pipelined", "coarse", "concurrent", "iterated"}) {
        std::printf("%s: ", mode);
        check(close_books(test::small_pipe("pressure_gradient: 20 kPa/m, reverse_at: { axis_speed: 0.5 m/s }",
                                           std::string("added_mass: on, lift: on, torque: on, mode: ") + mode),
                          40));
    }
}

TEST_CASE("what flows in below a bed and out above it is the only momentum that finite volumes bring")
{
    for (const char* mode : {"pipelined", "coarse"}) {
        std::printf("open, %s: ", mode);
        const Closing closing = close_books(test::scene_from_text(std::string(R"(name: bed in a flow
grid: { box: { size: [12 mm, 24 mm, 12 mm], cells: [6, 12, 6], blocks: [1, 2, 1] }, periodic: [x, z] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  boundaries:
    - { at: y_low, kind: inflow, velocity: [0 m/s, 80 mm/s, 0 m/s] }
    - { at: y_high, kind: outflow }
gravity: { direction: -y }
particles: [ { name: glass, count: 120, diameter: 2 mm, density: 2500 kg/m3, initial: { high: [12 mm, 12 mm, 12 mm] } } ]
contact: { stiffness: 2 kN/m, restitution: 0.6, friction: 0.4 }
coupling: { added_mass: on, mode: )") + mode + R"( }
run: { settle: 50 ms, until: 1 s, time_step: 1 ms }
)"),
                                            40);
        check(closing);
        CHECK(closing.through > 1e-9); // N s
    }
}

TEST_CASE("finite volumes keep momentum across sides whose points do not match")
{
    const test::BoxesFile file(core::Communicator::self(), {{{0, 0, 0}, {8e-3, 16e-3, 8e-3}, {6, 12, 6}, {1, 1, 1}, {}},
                                                            {{8e-3, 0, 0}, {16e-3, 16e-3, 8e-3}, {9, 16, 9}, {1, 1, 1}, {}}});
    check(close_books(test::bed_across_a_side(file, "pipelined"), 30));
}

TEST_CASE("grains that move with a uniform flow feel nothing and change nothing by finite volumes either")
{
    for (const io::CouplingMode mode : test::every_mode) {
        test::CoupledBox box;
        box.size = {16e-3, 16e-3, 16e-3};
        box.cells = {8, 8, 8};
        box.blocks = {2, 1, 1};
        box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
        box.mode = mode;
        const Vec3 u(0.3, 0.2, -0.1);
        test::CoupledRun run(by_finite_volumes(scene_of(box, 100)), "serial", core::Communicator::self());
        run.start(u, u);
        for (int n = 1; n <= 50; ++n) run.step();
        std::printf("uniform flow, %s: fluid %.1e, grains %.1e m/s\n", run.world().mode_reason().c_str(), run.fluid_deviation(u),
                    run.grain_deviation(u));
        // What the solver leaves of the disagreement of flux and places counts as momentum: up to 1e-8 of what flows through a cell, a
        // fifth of it in each of 50 steps.
        CHECK(run.fluid_deviation(u) < 1e-8);
        CHECK(run.grain_deviation(u) < 1e-8);
    }
}

TEST_CASE("a fixed bed between clear fluid lets through what Ergun's law says, and nothing grows at its surfaces")
{
    // A slab across a periodic stream: fluid fraction 0.6 in the middle, 1 outside.
    const double d = 2e-3, edge = 16e-3 / 6, gradient = 2000;
    test::CoupledBox box;
    box.size = {48e-3, 16e-3, 16e-3};
    box.cells = {24, 8, 8};
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.density_ratio = 1e7;
    box.drag = io::DragLaw::seed;
    box.added_mass = false;
    box.pressure_gradient = gradient;
    std::vector<Vec3> places;
    core::for_each({0, 0, 0}, {6, 6, 6}, [&](int i, int j, int k) {
        places.push_back(Vec3(16e-3, 1e-4, 2e-4) + edge * Vec3(i, j, k));
        places.push_back(Vec3(16e-3, 1e-4, 2e-4) + edge * Vec3(i + 0.5, j + 0.5, k + 0.5));
    });
    std::array<double, 2> superficial{};
    for (const bool by_volumes : {true, false}) {
        test::CoupledRun run(by_volumes ? by_finite_volumes(scene_of(box, 1)) : scene_of(box, 1), "serial", core::Communicator::self());
        run.place(places);
        run.start();
        for (int n = 0; n < 300; ++n) run.step();
        const auto& fraction = run.world().coupling()->fields().fraction;
        const auto& velocity = run.world().fluid()->state().velocity;
        superficial[by_volumes] = run.integral([&](core::LocalBlock b, int i, int j, int k) {
            return fraction.on(b)(i, j, k) * velocity.on(b).x(i, j, k);
        }) / box.size.prod();
        double across = 0, fastest = 0, slowest = 1, least = 1;
        core::for_each_cell(run.world().mesh().geometry(0).cells, [&](int i, int j, int k) {
            across = std::max(across, std::abs(velocity.on(0).y(i, j, k)));
            fastest = std::max(fastest, fraction.on(0)(i, j, k) * velocity.on(0).x(i, j, k));
            slowest = std::min(slowest, fraction.on(0)(i, j, k) * velocity.on(0).x(i, j, k));
            least = std::min(least, fraction.on(0)(i, j, k));
        });
        std::printf("slab, finite volumes %d: %.6f m/s, flux from %.6f to %.6f, across %.1e m/s, least fraction %.2f\n", by_volumes,
                    superficial[by_volumes], slowest, fastest, across, least);
        CHECK(fastest < 1.1 * superficial[by_volumes]);
        CHECK(slowest > 0.9 * superficial[by_volumes]);
    }
    CHECK(superficial[1] == test::relative(superficial[0]).epsilon(0.02)); // drag decides, and both schemes are of second order
}
