// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Walls of a scene beside those of its grid.
#include "io/run/world_walls.hpp"
#include "io/scene/scene_writer.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Vec3;
using test_scene::problem_of;

namespace {

std::string with_walls(const std::string& walls) { return test_scene::with("run:", "walls:\n" + walls + "run:"); }

const std::string plane = "plane: { point: [0 m, 0 m, 0 m], normal: z }";

} // namespace

TEST_CASE("walls have one shape and a name of their own")
{
    CHECK(problem_of(with_walls("  - { name: floor, " + plane + " }\n")) == "");
    CHECK(problem_of(with_walls("  - { name: floor }\n")) == "12:5 'plane' is missing");
    CHECK(problem_of(with_walls("  - { name: floor, " + plane + ", cylinder: { point: [0 m, 0 m, 0 m], axis: z, radius: 1 m } }\n")) ==
          "12:66 'plane' excludes 'cylinder'");
    CHECK(problem_of(with_walls("  - { name: floor, " + plane + " }\n  - { name: floor, " + plane + " }\n")) ==
          "13:13 two walls are named 'floor'");
    CHECK(problem_of(with_walls("  - { name: 'the floor', " + plane + " }\n")) ==
          "12:13 'the floor' is no name for columns of metrics.csv");
}

TEST_CASE("a motion moves something, and stops after it starts")
{
    const auto moved = [](const std::string& motion) {
        return problem_of(with_walls("  - { name: floor, " + plane + ",\n      motion: { " + motion + " } }\n"));
    };
    CHECK(moved("velocity: [0 m/s, 1 m/s, 0 m/s], start: 1 s, stop: 2 s") == "");
    CHECK(moved("start: 1 s") == "13:7 nothing moves this wall");
    CHECK(moved("velocity: [0 m/s, 1 m/s, 0 m/s], start: 1 s, stop: 1 s") == "13:68 the wall stops before it starts");
}

TEST_CASE("a moving wall is written and read back, and becomes one of physics relative to the domain's origin")
{
    const std::string text = with_walls("  - name: drum\n"
                                        "    cylinder: { point: [1 m, 0 m, 2 m], axis: -y, radius: 30 cm, particles: outside }\n"
                                        "    motion:\n"
                                        "      rotation: { point: [1 m, 0 m, 2 m], axis: -y, rate: 30 rpm }\n"
                                        "      oscillation: { amplitude: [0 mm, 2 mm, 0 mm], frequency: 5 Hz, phase: 90 degrees }\n"
                                        "      stop: 4 s\n");
    const auto [scene, problems] = io::read_scene_text("scene", text);
    CHECK(problems->text() == "");
    const auto [again, more] = io::read_scene_text("resolved", io::scene_text(scene));
    CHECK(more->text() == "");
    CHECK(again == scene);
    const auto walls = io::own_walls(scene, Vec3(0, 0, 1));
    REQUIRE(walls.size() == 1);
    const auto& drum = std::get<physics::CylinderWall>(walls.front());
    CHECK(drum.particles == physics::WallSide::outside);
    CHECK((drum.point - Vec3(1, 0, 1)).norm() == 0.0);
    CHECK((drum.motion.axis_point - Vec3(1, 0, 1)).norm() == 0.0);
    CHECK((drum.motion.angular_velocity - Vec3(0, -std::numbers::pi, 0)).norm() < 1e-14); // rounding
    CHECK(drum.motion.angular_frequency == doctest::Approx(10 * std::numbers::pi));
    CHECK(drum.motion.phase == doctest::Approx(std::numbers::pi / 2));
    CHECK(drum.motion.stop == 4.0);
}
