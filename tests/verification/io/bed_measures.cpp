// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What is measured of a bed as a whole: large above small, waves along it, layers in a round pipe, their table.
#include "core/base/random.hpp"
#include "io/run/metric_groups.hpp"
#include "io/run/world_profile.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace {

io::Scene scene(const std::string& grid, const std::string& measure)
{
    return test::scene_from_text("name: bed\ngrid: " + grid +
                                 "\ngravity: { direction: -y }\nparticles:\n"
                                 "  - { name: S, count: 300, diameter: 1 mm, density: 2500 kg/m3 }\n"
                                 "  - { name: L, count: 100, diameter: 2 mm, density: 2500 kg/m3 }\n"
                                 "contact: { stiffness: 500 N/m, walls: primitive }\noutput: { results: every 1 s, grains: [" +
                                 measure + "] }\nrun: { until: 1 s }\n");
}

const std::string box = "{ box: { size: [80 mm, 24 mm, 20 mm], cells: [8, 4, 2], blocks: [1, 2, 1] }, periodic: [x] }";

} // namespace

TEST_CASE("segregation is the lift of the large in their diameters, and a wave of the bed is found with its amplitude")
{
    io::World world(scene(box, "segregation"), core::Communicator::self());
    core::ParticleSet& p = world.grains()->particles;
    const double amplitude = 0.3, number = 2 * 2 * std::numbers::pi / 80e-3; // two waves
    for (int i = 0; i < p.owned; ++i) {
        const auto n = std::size_t(i);
        const bool large = p.species[n] == 1;
        p.position[1][n] = large ? 10e-3 : 4e-3;
        const double share = large ? (double(p.id[n] - 300) + 0.5) / 100 : (double(p.id[n]) + 0.5) / 300;
        double x = 80e-3 * share; // x + a sin(k x) / k = 80 mm x share
        for (int pass = 0; pass < 60; ++pass) x = 80e-3 * share - amplitude / number * std::sin(number * x);
        p.position[0][n] = x;
    }
    const io::MetricGroup group = io::segregation_metrics(world);
    REQUIRE(group.names.size() == 5);
    CHECK(group.names[2] == "waves_x_2");
    const auto values = group.values();
    CHECK(values[0] == test::relative(3.0).epsilon(1e-12));
    CHECK(values[2] == test::relative(amplitude).epsilon(1e-6)); // midpoints of 100 and 300 quantiles of a periodic density
    for (const std::size_t other : {1, 3}) CHECK(values[other] < 1e-6);
}

TEST_CASE("below each layer of a round pipe lies the room of a segment of its section")
{
    const double radius = 25e-3, length = 60e-3;
    const io::World world(scene("{ pipe: { diameter: 50 mm, length: 60 mm, size: large, blocks_along: 2 }, periodic: [axial] }", "profile"),
                          core::Communicator::self());
    const io::BedLayers layers = io::BedLayering(world).of(world);
    double below = 0;
    for (std::size_t n = 0; n < layers.room.size(); ++n) {
        below += layers.room[n];
        const double h = std::clamp((layers.middle(n) + 0.5 * layers.thickness) / radius, -1.0, 1.0);
        const double segment = radius * radius * (std::asin(h) + h * std::sqrt(1 - h * h) + 0.5 * std::numbers::pi);
        // Cells of 2 mm, each as wide everywhere between its lowest and its highest corner.
        CHECK(std::abs(below - segment * length) < 0.01 * std::numbers::pi * radius * radius * length);
    }
    CHECK(below == test::relative(world.mesh().total_volume()).epsilon(1e-12));
}

TEST_CASE("a profile holds every grain once, kind by kind")
{
    const TemporaryFolder folder;
    io::World world(scene(box, "profile"), core::Communicator::self());
    io::WorldProfile profile(world, folder.path() / "profile.csv", {});
    profile.write(world);
    profile.flush();
    const io::MetricsTable table = io::read_metrics(folder.path() / "profile.csv");
    CHECK(table.columns == std::vector<std::string>{"time", "height", "fraction", "speed", "fraction_S", "fraction_L"});
    const double layer = 80e-3 * 20e-3 * (table.rows[1][1] - table.rows[0][1]);
    double small = 0, large = 0;
    for (const auto& row : table.rows) {
        small += row[4] * layer;
        large += row[5] * layer;
        CHECK(row[2] == test::relative(row[4] + row[5]).epsilon(1e-12));
    }
    CHECK(small == test::relative(300 * std::numbers::pi / 6 * 1e-9).epsilon(1e-9)); // heights of layers have nine digits left
    CHECK(large == test::relative(100 * std::numbers::pi / 6 * 8e-9).epsilon(1e-9));
}
