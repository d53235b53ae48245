// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What is measured of grains in cells: contacts of a crystal, temperature of a gas, weight of a column, mixing of a checkerboard.
// ctest: timeout=60
#include "core/base/random.hpp"
#include "core/comm/reduce.hpp"
#include "core/grid/extents.hpp"
#include "io/run/grain_fields.hpp"
#include "io/run/world.hpp"
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <doctest/doctest.h>

namespace {

io::Scene scene(const std::string& keys, const std::string& periodic, const std::string& grain)
{
    return test::scene_from_text(
        "name: measured\ngrid: { box: { size: [20 mm, 24 mm, 20 mm], cells: [2, 4, 2], blocks: [1, 2, 1] }, periodic: [" + periodic +
        "] }\n" + keys + "particles:\n  - { name: S, " + grain +
        ", density: 2500 kg/m3 }\n"
        "contact: { stiffness: 500 N/m, restitution: 0.3, friction: 0.5, walls: primitive }\n"
        "output: { grains: [contacts, motion, mixing] }\nrun: { until: 1 s }\n");
}

/// Sum over all cells of a field times their volumes.
double integral(const io::World& world, const core::ScalarField& field)
{
    double sum = 0;
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
        core::for_each_cell(world.mesh().geometry(b).cells,
                            [&](int i, int j, int k) { sum += world.mesh().geometry(b).volume.view()(i, j, k) * field.on(b)(i, j, k); });
    return sum;
}

} // namespace

TEST_CASE("each sphere of a squeezed crystal of face-centred cubes touches twelve, and all squeeze alike in all directions")
{
    // Seven cubes of 20/7 mm fit best.
    io::World world(
        test::scene_from_text(
            "name: crystal\ngrid: { box: { size: [20 mm, 20 mm, 20 mm], cells: [2, 2, 2], blocks: [1, 2, 1] }, periodic: [x, y, z] }\n"
            "particles:\n  - { name: S, count: 1372, diameter: 2.05 mm, density: 2500 kg/m3, initial: { arrangement: packed, "
            "spacing: 0.98 } }\ncontact: { stiffness: 500 N/m, walls: primitive }\n"
            "output: { grains: [contacts] }\nrun: { until: 1 s, time_step: 0.1 us }\n"),
        core::Communicator::self());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    world.step(*executor);
    io::GrainFields fields(world);
    fields.find(world);
    const double edge = 20e-3 / 7, apart = edge / std::sqrt(2.0), overlap = 2.05e-3 - apart;
    REQUIRE(overlap > 0);
    // Love and Weber: each of six contacts per sphere has force k x overlap along a branch of length `apart`; a third in each direction.
    const double pressure = 1372 * 6 * 500 * overlap * apart / (3 * 8e-6);
    for (core::LocalBlock b = 0; b < 2; ++b)
        core::for_each_cell(world.mesh().geometry(b).cells,
                            [&](int i, int j, int k) { CHECK(fields.contacts()[0].on(b)(i, j, k) == 12.0); });
    for (std::size_t n = 0; n < 3; ++n) CHECK(integral(world, fields.stress()[n]) / 8e-6 == test::relative(pressure).epsilon(1e-6));
    for (std::size_t n = 3; n < 6; ++n) CHECK(std::abs(integral(world, fields.stress()[n]) / 8e-6) < 1e-6 * pressure); // rounding of sums
}

TEST_CASE("grains that fly at random have the temperature and the pressure of a gas, whatever their mean flow")
{
    io::World world(scene("", "x, y, z", "count: 1600, diameter: 0.5 mm"), core::Communicator::self());
    core::ParticleSet& p = world.grains()->particles;
    const double speed = 0.3; // uniform in [-speed, speed] along each axis: a variance of speed^2 / 3
    for (int i = 0; i < p.owned; ++i) {
        const auto u = core::random_uniform(9, p.id[std::size_t(i)], 0);
        for (std::size_t a = 0; a < 3; ++a) p.velocity[a][std::size_t(i)] = speed * (2 * u[a] - 1) + (a == 0 ? 1000.0 : 0.0);
    }
    io::GrainFields fields(world);
    fields.find(world);
    const double volume = 9.6e-6, mass = p.mass[0], density = 1600 * mass / volume;
    CHECK(integral(world, fields.fraction()) == test::relative(1600 * mass / 2500).epsilon(1e-12));
    // Of 100 grains in each of 16 cells one degree of freedom goes to their mean; 3 x 1600 velocities: three deviations are 3 %.
    const double expected = speed * speed / 3 * (1 - 16.0 / 1600);
    double temperature = 0;
    for (core::LocalBlock b = 0; b < 2; ++b)
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
            temperature += fields.temperature().on(b)(i, j, k) * fields.fraction().on(b)(i, j, k);
        });
    temperature /= integral(world, fields.fraction()) / (volume / 16);
    CHECK(temperature == test::relative(expected).epsilon(0.03));
    const double pressure =
        (integral(world, fields.stress()[0]) + integral(world, fields.stress()[1]) + integral(world, fields.stress()[2])) / 3;
    CHECK(pressure / volume == test::relative(density * temperature).epsilon(1e-9)); // the same sums, by cells or by grains
}

TEST_CASE("stress at rest carries the weight: its integral is the moment of the weights about the floor")
{
    io::World world(scene("gravity: { direction: -y }\n", "x, z", "count: 600, diameter: 2 mm"), core::Communicator::self());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    while (world.time() < 0.5) world.step(*executor);
    io::GrainFields fields(world);
    fields.find(world);
    const core::ParticleSet& p = world.grains()->particles;
    double moment = 0;
    for (int i = 0; i < p.owned; ++i) moment += 9.81 * p.mass[std::size_t(i)] * p.position[1][std::size_t(i)];
    // The floor pushes at height 0, where it has no moment. At rest to some 1e-3 of the weight.
    CHECK(integral(world, fields.stress()[1]) == test::relative(moment).epsilon(5e-3));
    // A layer of cells carries what lies above its middle, to a part of a grain's weight per area: the lower half of the upper cells.
    const double area = 4e-4;
    double lowest = 0;
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) lowest += fields.stress()[1].on(0)(i, 1, k) / 4; // 6 to 12 mm
    double above = 0;
    for (int i = 0; i < p.owned; ++i) { // the share of the layer below each grain's weight
        const double y = p.position[1][std::size_t(i)];
        above += 9.81 * p.mass[std::size_t(i)] * std::clamp((y - 6e-3) / 6e-3, 0.0, 1.0);
    }
    CHECK(lowest == test::relative(above / area).epsilon(0.1)); // grains of 2 mm count as a whole where their centre is, in 6 mm
}

TEST_CASE("a column of spheres has the stress of its weight from the top to the floor, whatever the floor is made of")
{
    const int count = 8;
    const double radius = 1e-3, stiffness = 1e4, area = 25e-6, weight = 9.81 * 2500 * 4.0 / 3.0 * std::numbers::pi * 1e-9;
    const std::string plane = "walls: [{ name: floor, plane: { point: [0 m, 0 m, 0 m], normal: y } }]\n",
                      disc = "walls: [{ name: floor, disc: { point: [2.5 mm, 0 m, 2.5 mm], normal: y, radius: 4 mm } }]\n";
    for (const auto& [walls, own] :
         {std::pair<std::string, std::string>{"primitive", ""}, {"faces", ""}, {"none", plane}, {"none", disc}}) {
        CAPTURE(walls + own);
        io::World world(
            test::scene_from_text("name: column\ngrid: { box: { size: [5 mm, 20 mm, 5 mm], cells: [1, 5, 1] }, periodic: [x, z] }\n"
                                  "gravity: { direction: -y }\nparticles:\n  - { name: S, count: 8, diameter: 2 mm, density: 2500 kg/m3, "
                                  "initial: { arrangement: lattice } }\ncontact: { stiffness: 10 kN/m, walls: " +
                                  walls + " }\n" + own + "output: { grains: [contacts] }\nrun: { until: 1 s, time_step: 1 ms }\n"),
            core::Communicator::self());
        core::ParticleSet& p = world.grains()->particles;
        const auto overlap = [&](int below) { return (count - below) * weight / stiffness; }; // under a sphere that `below` others carry
        double height = -radius;
        for (int n = 0; n < count; ++n) {
            const auto i = std::size_t(test::place(p, n));
            height += 2 * radius - overlap(n);
            p.position[0][i] = p.position[2][i] = 2.5e-3;
            p.position[1][i] = height;
        }
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        world.step(*executor);
        io::GrainFields fields(world);
        fields.find(world);
        for (int cell = 0; cell < 4; ++cell) { // of two spheres each
            double expected = 0;
            for (int n = 2 * cell; n < 2 * cell + 2; ++n)
                expected += (count - n) * weight * (radius - overlap(n) / (n == 0 ? 1 : 2)) +
                            (count - n - 1) * weight * (radius - overlap(n + 1) / 2);
            CAPTURE(cell);
            const double stress = fields.stress()[1].on(0)(0, cell, 0);
            CHECK(stress * area * 4e-3 == test::relative(expected).epsilon(1e-8)); // places are known to 1e-10 of the overlaps
            // the weight above the cell's middle; spheres overlap by 1e-4 of their radius
            CHECK(stress * area == test::relative((count - 2 * cell - 1) * weight).epsilon(1e-4));
            CHECK(fields.contacts()[0].on(0)(0, cell, 0) == (cell == 0 || cell == 3 ? 1.5 : 2.0));
            CHECK(fields.contacts()[1].on(0)(0, cell, 0) == (cell == 0 ? 0.5 : 0.0));
        }
        if (own.empty()) continue;
        const auto loads = world.grains()->loads();
        CHECK(loads.at(0).sum[1].value() / world.grains()->load_steps() == test::relative(-count * weight).epsilon(1e-8)); // the same
    }
}

TEST_CASE("Lacey's index is 0 for kinds apart, and 1 on average for kinds dealt by chance")
{
    CHECK(std::abs(io::lacey_index({{10, 0}, {0, 10}, {10, 0}, {0, 0}})) < 1e-12); // rounding of 1 - 1
    CHECK(io::lacey_index({{10, 0}, {10, 0}}) == 0.0);
    CHECK(io::lacey_index({}) == 0.0);
    constexpr int deals = 400, cells = 50, each = 8;
    double mean = 0;
    for (int deal = 0; deal < deals; ++deal) {
        std::vector<std::array<std::int64_t, 2>> counts(cells, {0, 0});
        for (int n = 0; n < cells * each; ++n) {
            const auto u = core::random_uniform(11, n, std::uint64_t(deal));
            ++counts[std::size_t(n / each)][u[0] < 0.3 ? 0 : 1];
        }
        mean += io::lacey_index(counts) / deals;
    }
    CHECK(mean == test::relative(1.0).epsilon(0.01)); // the variance of 50 cells is known to 20 %, a seventh of that counts, over 400 deals
}
