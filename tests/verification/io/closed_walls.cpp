// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Particles that are placed beside walls from STL files: clear of the triangles, and on the side of closed ones that the scene says.
// ctest: timeout=60
#include "core/base/error.hpp"
#include "io/files/stl.hpp"
#include "io/run/world.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/triangles.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

constexpr double drum_radius = 10e-3;

/// A closed drum of 10 mm by 20 mm along x in a box that is larger than it.
/// @param side  Of the drum, as keys of the STL. @param species  Keys. @param motion  Of the drum.
std::string scene(const std::string& folder, const std::string& side, const std::string& species, const std::string& motion = "")
{
    return "name: drum\ngrid: { box: { size: [28 mm, 28 mm, 28 mm], cells: [4, 4, 4], blocks: [2, 1, 1] } }\ngravity: { direction: -y }\n"
           "particles:\n  - { name: S, " +
           species +
           ", diameter: 1.5 mm, density: 2500 kg/m3 }\ncontact: { stiffness: 200 N/m, friction: 0.4, walls: primitive }\n"
           "walls: [{ name: drum, stl: { file: " +
           folder + "/drum.stl, at: [4 mm, 14 mm, 14 mm]" + side + " }" + motion + " }]\nrun: { until: 1 s, time_step: 1 ms }\n";
}

/// How far the centres of all particles are inside the drum, of radius 10 mm from x = 4 mm to 24 mm; negative outside [m].
std::vector<double> depths(const io::World& world)
{
    std::vector<double> all;
    const core::ParticleSet& p = world.grains()->particles;
    for (int i = 0; i < p.owned; ++i) {
        const Vec3 x = p.position_of(i);
        const double round = drum_radius - std::hypot(x.y() - 14e-3, x.z() - 14e-3), along = 10e-3 - std::abs(x.x() - 14e-3);
        // outside, the distance from the nearest point
        all.push_back(round >= 0 && along >= 0 ? std::min(round, along) : -std::hypot(std::min(0.0, round), std::min(0.0, along)));
    }
    return all;
}

/// The folder with the drum's file.
struct Files : TemporaryFolder {
    Files() { io::write_stl(path() / "drum.stl", test::drum(drum_radius, 20e-3, 60, 20)); }
    [[nodiscard]] std::string name() const { return path().string(); }
};

constexpr double radius = 0.75e-3, sagitta = 14e-6; // of 60 facets, which are bent to the round drum

} // namespace

TEST_CASE("particles are placed clear of a closed drum, inside or outside as it says")
{
    const Files files;
    for (const std::string arrangement : {"random", "lattice"})
        for (const std::string side : {"", "inside", "outside"}) {
            CAPTURE(arrangement);
            CAPTURE(side);
            const std::string keys = "count: 300, initial: { arrangement: " + arrangement + " }";
            const io::World world(test::scene_from_text(scene(files.name(), side.empty() ? "" : ", particles: " + side, keys)),
                                  core::Communicator::self());
            int inside = 0;
            for (const double depth : depths(world)) {
                CHECK(std::abs(depth) > radius - sagitta - (arrangement == "lattice" ? 0.005 * radius : 0.0)); // a little off the lattice
                inside += depth > 0;
            }
            if (side == "inside") CHECK(inside == 300);
            if (side == "outside") CHECK(inside == 0);
            if (side.empty() && arrangement == "random") CHECK((inside > 30 && inside < 270));
        }
}

TEST_CASE("particles that come into a turning drum come in on its inside, and stay there")
{
    const Files files;
    io::World world(test::scene_from_text(scene(files.name(), ", particles: inside",
                                                "count: 0, inflow: { rate: 3000 Hz, low: [1 mm, 1 mm, 1 mm], high: [27 mm, 27 mm, 27 mm] }",
                                                ", motion: { rotation: { point: [4 mm, 14 mm, 14 mm], axis: x, rate: 60 rpm } }")),
                    core::Communicator::self());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    for (int step = 0; step < 60; ++step) world.step(*executor);
    const auto all = depths(world);
    CHECK(all.size() > 170);                                    // 3000 Hz in 59 ms
    for (const double depth : all) CHECK(depth > 0.8 * radius); // soft springs
}

TEST_CASE("what lies on the wrong side of a drum is refused, as is a side of what is open")
{
    const Files files;
    std::ofstream(files.path() / "grains.csv") << "x,y,z,diameter,density,species\n0.002,0.002,0.002,0.0015,2500,S\n";
    const auto text = scene(files.name(), ", particles: inside", "file: " + files.name() + "/grains.csv");
    std::string one = text;
    one.erase(one.find(", diameter: 1.5 mm"), std::string(", diameter: 1.5 mm").size());
    CHECK_THROWS_WITH_AS(io::World(test::scene_from_text(one), core::Communicator::self()),
                         doctest::Contains("lies on the wrong side of the wall 'drum'"), core::ConfigError);
    auto open = test::drum(drum_radius, 20e-3, 60, 20);
    open.pop_back();
    io::write_stl(files.path() / "drum.stl", open);
    const auto problems = io::read_scene_text("scene.yaml", scene(files.name(), ", particles: inside", "count: 1")).problems->sorted();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].message.find("it has no inside") != std::string::npos);
}
