// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_writer.hpp"
#include "scene_text.hpp"
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>

namespace {

using test_scene::problem_of;
using test_scene::with;

const std::string gradient = "pressure_gradient: 33.3 kPa/m";

std::string drive(const std::string& keys) { return with(gradient, keys); }

} // namespace

TEST_CASE("a drive gives exactly one of gradient, flow rate and bulk velocity")
{
    CHECK(problem_of(drive("flow_rate: 1 l/s")) == "");
    CHECK(problem_of(drive("bulk_velocity: 2 m/s, frequency: 2 Hz")) == "");
    CHECK(problem_of(drive("axis: x")) == "7:3 'pressure_gradient' is missing");
    CHECK(problem_of(drive("flow_rate: 1 l/s, bulk_velocity: 1 m/s")) == "7:30 'flow_rate' excludes 'bulk_velocity'");
    CHECK(problem_of(drive("flow_rate: 1 l/s, reverse_at: { axis_speed: 1 m/s }")) == "7:30 'reverse_at' needs 'pressure_gradient'");
}

TEST_CASE("courses in time are checked where they stand")
{
    const auto over_time = [](const std::string& keys) { return problem_of(drive("flow_rate: 1 l/s, over_time: { " + keys + " }")); };
    CHECK(over_time("frequency: 2 Hz, mean: 1, amplitude: 0.5, phase: 1.57 rad") == "");
    CHECK(over_time("table: [[0 s, 0], [1 s, 1]]") == "");
    CHECK(over_time("table: [[0 s, 0], [500 ms, 1]], beyond: hold, between: cubic") == "");
    CHECK(over_time("table: [[0 s, 0], [0.5 s, 1]]") == "7:30 the table ends at 0.5 s, before the run does at 1 s");
    CHECK(over_time("table: [[0 s, 0], [0.5 s, 1]], beyond: repeat") ==
          "7:30 a table that repeats must end with the value that it begins with");
    CHECK(over_time("table: [[0 s, 0], [2 s, 1], [1 s, 2]]") == "7:71 the times of a table must increase, and 1 s follows 2 s");
    CHECK(over_time("table: [[0 s, 0], [2 s]]") == "7:61 a point [time, value] is needed here");
    CHECK(over_time("table: [[0 s, 0], [2 m, 1]]").starts_with("7:62 "));
    CHECK(over_time("table: [[0.1 s, 0], [2 s, 1]]") == "7:30 the table begins at 0.1 s, after the run");
    CHECK(over_time("frequency: 1 Hz, beyond: hold") == "7:68 'beyond' means nothing beside 'frequency'");
    CHECK(over_time("file: nowhere.csv") == "7:49 nowhere.csv cannot be read");
}

TEST_CASE("a table comes from a file, and the resolved scene holds it")
{
    const auto file = std::filesystem::temp_directory_path() / "isago_course_keys_test.csv";
    std::ofstream(file) << "time, factor\n# a comment\n0, 0\n0.5; 1.5\n\n2 1\n";
    const std::string text = drive("flow_rate: 1 l/s, over_time: { file: " + file.string() + " }");
    const auto [scene, problems] = io::read_scene_text("scene.yaml", text);
    CHECK(problems->text() == "");
    CHECK(scene.fluid->drive->over_time->table == io::CoursePoints{{0, 0}, {0.5, 1.5}, {2, 1}});
    const auto [again, no_problems] = io::read_scene_text("resolved", io::scene_text(scene));
    CHECK(no_problems->text() == "");
    CHECK(again == scene);
    std::ofstream(file) << "0, 0\n1, one\n";
    CHECK(problem_of(text).ends_with("isago_course_keys_test.csv:2: 2 numbers are needed, not '1, one'"));
    std::filesystem::remove(file);
}

TEST_CASE("a flow is not prescribed where fluid enters elsewhere")
{
    const std::string text = R"(name: test
grid: { box: { size: [1 m, 1 m, 1 m], cells: [4, 4, 4] }, periodic: [x, z] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  drive: { flow_rate: 1 l/s }
  boundaries: [{ at: y_low, kind: pressure }]
run: { until: 1 s }
)";
    CHECK(problem_of(text) == "5:3 a flow cannot be prescribed where fluid also goes through 'y_low'");
}

TEST_CASE("what flows in may be laminar, come from points and change in time; walls may change in time")
{
    const auto channel = [](const std::string& inflow, const std::string& wall = "velocity: [1 m/s, 0 m/s, 0 m/s]") {
        return R"(name: test
grid: { box: { size: [1 m, 1 m, 1 m], cells: [4, 4, 4] }, periodic: [z] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  boundaries:
    - { at: x_low, kind: inflow, )" +
               inflow + R"( }
    - { at: x_high, kind: outflow }
    - { at: y_high, )" +
               wall + R"( }
run: { until: 1 s }
)";
    };
    const std::string velocity = "velocity: [1 m/s, 0 m/s, 0 m/s]", course = "over_time: { table: [[0 s, 0], [1 s, 1]] }";
    CHECK(problem_of(channel(velocity + ", profile: laminar, " + course, velocity + ", " + course)) == "");
    CHECK(problem_of(channel("profile: laminar")) == "6:7 an inflow needs 'velocity'");
    CHECK(problem_of(channel(velocity, velocity + ", profile: laminar")) == "8:63 'profile' means nothing for kind: wall");
    CHECK(problem_of(channel("profile_file: nowhere.txt")).ends_with("nowhere.txt cannot be read"));
    CHECK(problem_of(channel(velocity + ", over_time: { table: [[0 s, 0], [0.5 s, 1]] }")) ==
          "6:67 the table ends at 0.5 s, before the run does at 1 s");
    const auto file = std::filesystem::temp_directory_path() / "isago_profile_test.txt";
    std::ofstream(file) << "x y z u v w\n0 0 0 1 0 0\n0 1 0 2 0 0\n";
    const auto [scene, problems] = io::read_scene_text("scene.yaml", channel("profile_file: " + file.string()));
    CHECK(problems->text() == "");
    CHECK(scene.fluid->boundaries[0].profile_file == file.string());
    const auto [again, no_problems] = io::read_scene_text("resolved", io::scene_text(scene));
    CHECK(no_problems->text() == "");
    CHECK(again == scene);
    std::filesystem::remove(file);
}
