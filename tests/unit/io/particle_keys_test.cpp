// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Where particles of scenes are, come in and go out.
#include "core/base/error.hpp"
#include "io/run/grain_file.hpp"
#include "io/scene/scene_writer.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/unit/io/scene_text.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <doctest/doctest.h>
#include <fstream>
#include <numbers>

using test_scene::problem_of;
using test_scene::with;

namespace {

const std::string dry = R"(name: dry
grid: { box: { size: [0.1 m, 0.2 m, 0.1 m], cells: [4, 8, 4], blocks: [1, 2, 1] }, periodic: [x] }
particles:
  - { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }
contact: { stiffness: 5 kN/m }
run: { until: 1 s }
)";

std::string species(const std::string& keys) { return with("count: 10, diameter: 2 mm", keys, dry); }

/// What is wrong with a table of grains.
std::string mistake_in(const std::filesystem::path& file, const std::string& table)
{
    std::ofstream(file) << table;
    try {
        (void)io::grains_of_table(file, {"sand", "gravel"});
        return "";
    } catch (const core::ConfigError& error) {
        return std::string(error.what()).substr(file.string().size());
    }
}

} // namespace

TEST_CASE("a volume fraction becomes a count: of the domain, of a cylinder, of a sphere that a wall cuts in half")
{
    const auto count = [](const std::string& keys) { return *test::scene_from_text(species(keys)).particles[0].count; };
    const double grain = std::numbers::pi / 6 * 8e-9;
    CHECK(count("volume_fraction: 0.2, diameter: 2 mm") == std::lround(0.2 * 2e-3 / grain));
    const std::string cylinder = "initial: { cylinder: { from: [0.05 m, 0.05 m, 0.05 m], to: [0.05 m, 0.15 m, 0.05 m], radius: 19 mm } }";
    // Spheres of 1 mm reach that far beyond its mantle and ends.
    CHECK(count("volume_fraction: 0.2, diameter: 2 mm, " + cylinder) == std::lround(0.2 * std::numbers::pi * 4e-4 * 0.102 / grain));
    const std::string sphere = "initial: { sphere: { centre: [0.05 m, 0 m, 0.05 m], radius: 29 mm } }";
    const double half = 2.0 / 3.0 * std::numbers::pi * 27e-6; // counted on 100^3 points: to a thousandth
    CHECK(count("volume_fraction: 0.2, diameter: 2 mm, " + sphere) == test::relative(0.2 * half / grain).epsilon(2e-3));
    CHECK(problem_of(species("volume_fraction: 0.5, diameter: 2 mm")).starts_with("4:33 the particles would fill 50 % of their region"));
    CHECK(problem_of(species("volume_fraction: 0.5, diameter: 2 mm, initial: { arrangement: dense }")) == "");
    CHECK(problem_of(species("volume_fraction: 0.5, count: 10, diameter: 2 mm")) == "4:38 'volume_fraction' excludes 'count'");
}

TEST_CASE("one particle finds its place at any point, two need room, also across a seam")
{
    const std::string point = "initial: { low: [0.01 m, 0.02 m, 0.03 m], high: [0.01 m, 0.02 m, 0.03 m] }";
    CHECK(problem_of(species("count: 1, diameter: 20 mm, " + point)) == "");
    CHECK(problem_of(species("count: 2, diameter: 20 mm, " + point)).starts_with("4:23 the particles would fill 105 % of their region"));
}

TEST_CASE("contacts far from the origin would be lost in round-off")
{
    CHECK(problem_of(with("0.1 m, 0.2 m, 0.1 m", "1000 km, 0.2 m, 0.1 m", dry)).starts_with("4:37 1e+06 m from the origin"));
    CHECK(problem_of(with("0.1 m, 0.2 m, 0.1 m", "1 km, 0.2 m, 0.1 m", dry)) == "");
}

TEST_CASE("a region has one form")
{
    const auto initial = [](const std::string& keys) { return species("count: 1, diameter: 2 mm, initial: { " + keys + " }"); };
    CHECK(problem_of(initial("sphere: { centre: [0 m, 0 m, 0 m], radius: 1 m }, low: [0.01 m, 0.01 m, 0.01 m]")) ==
          "4:108 'low' excludes 'sphere'");
    CHECK(problem_of(initial("cylinder: { from: [0 m, 0 m, 0 m], to: [0 m, 0 m, 0 m], radius: 1 m }")) ==
          "4:53 the cylinder has no length: 'from' is 'to'");
}

TEST_CASE("particles come in and go out of whole regions of the domain, at one rate, and not yet beside a fluid")
{
    const auto inflow = [](const std::string& keys) { return species("count: 0, diameter: 2 mm, inflow: { " + keys + " }"); };
    const std::string box = ", low: [0.01 m, 0.1 m, 0.01 m], high: [0.09 m, 0.19 m, 0.09 m]";
    CHECK(problem_of(inflow("rate: 100 Hz" + box)) == "");
    CHECK(problem_of(inflow("mass_rate: 1 g/s" + box)) == "");
    CHECK(problem_of(inflow("mass_rate: 1 g/s, rate: 2 Hz" + box)) == "4:70 'mass_rate' excludes 'rate'");
    CHECK(problem_of(inflow("rate: 100 Hz")) == "4:42 a region is needed");
    CHECK(problem_of(inflow("rate: 100 Hz, sphere: { centre: [1 m, 0 m, 0 m], radius: 1 m }")) ==
          "4:66 the region is not inside the domain");
    CHECK(problem_of(inflow("rate: 100 Hz, begin: 2 s, end: 1 s" + box)) == "4:83 the inflow ends before it begins");
    const io::Scene scene =
        test::scene_from_text(with("contact:", "outlets: [ { name: a, sphere: { centre: [0 m, 0 m, 0 m], radius: 1 mm } } ]\ncontact:",
                                   inflow("mass_rate: 0.3333333333333333 g/s, begin: 0.1 s, end: 0.7 s" + box)));
    CHECK(test::scene_from_text(io::scene_text(scene)) == scene); // the resolved text reads back
    const auto outlets = [](const std::string& list) { return with("contact:", "outlets: [ " + list + " ]\ncontact:", dry); };
    CHECK(problem_of(outlets("{ name: a, sphere: { centre: [0 m, 0 m, 0 m], radius: 1 mm } }")) == "");
    CHECK(problem_of(outlets("{ name: a, low: [0 m, 0 m, 0 m] }")) == "5:12 a region is needed");
}

TEST_CASE("tables of grains are read with their species by name or number, and mistakes are named by line and column")
{
    const TemporaryFolder folder;
    const auto file = std::filesystem::path(folder.path()) / "grains.csv";
    std::ofstream(file) << "x, y, z, diameter, density, species, u, v, w\n# a comment\n1e-2, 2e-2, 3e-2, 2e-3, 2500, gravel, 0, -1, 0\n"
                        << "1;2;3;4;5;0;7;8;9\n";
    const auto grains = io::grains_of_table(file, {"sand", "gravel"});
    REQUIRE(grains.size() == 2);
    CHECK(grains[0].position == core::Vec3(1e-2, 2e-2, 3e-2));
    CHECK(grains[0].radius == 1e-3);
    CHECK(grains[0].species == 1);
    CHECK(grains[0].velocity == core::Vec3(0, -1, 0));
    CHECK(grains[1].species == 0);
    CHECK(grains[1].density == 5);
    CHECK(mistake_in(file, "1 2 3 4 5 sand\n1 2 3 4 5 sans\n") == ":2:11: the scene has no species 'sans'; did you mean 'sand'?");
    CHECK(mistake_in(file, "1 2 3 4 5 sand\n1 two 3 4 5 sand\n") == ":2:3: 'two' is not a number");
    CHECK(mistake_in(file, "1 2 3 0 5 sand\n") == ":1:7: a diameter must be positive");
    CHECK(mistake_in(file, "1 2 3\n").starts_with(":1:1: 6 or 9 columns are needed"));
    CHECK(mistake_in(file, "x y z\n") == " has no particles");
    CHECK(problem_of(species("file: nowhere.csv")).ends_with("nowhere.csv cannot be read"));
    CHECK(problem_of(species("file: nowhere.csv, count: 3")).find("'file' excludes 'count'") != std::string::npos);
}
