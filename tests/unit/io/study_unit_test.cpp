// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/study/study_orders.hpp"
#include "temporary_folder.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <doctest/doctest.h>

namespace {

const std::string oscillating =
    "scene: { name: p, grid: { pipe: { diameter: 1 m, length: 1 m }, periodic: [axial] }, "
    "fluid: { w: { density: 1 kg/m3, viscosity: 1 m2/s }, drive: { pressure_gradient: 1 Pa/m, frequency: 1 Hz } }, run: { until: 1 s } }\n";

std::string refusal(const std::string& text)
{
    const TemporaryFolder folder;
    write_file(folder.path() / "study.yaml", text);
    try {
        (void)io::read_study(folder.path() / "study.yaml");
    } catch (const core::ConfigError& error) {
        return error.what();
    }
    return "";
}

io::StudyRun run_with(double h, double dt, double error, double wall, std::vector<int> choice)
{
    io::StudyRun run;
    run.h = h;
    run.dt = dt;
    run.error.e_2 = error;
    run.wall = wall;
    run.choice = std::move(choice);
    return run;
}

} // namespace

TEST_CASE("a study runs all combinations, the last axis fastest, with the period cut into steps")
{
    const TemporaryFolder folder;
    write_file(folder.path() / "study.yaml",
               "name: s\nerror: womersley\n" + oscillating + "vary: { cells: [[8, 4], [12, 4]], steps_per_period: [10, 20, 40] }\n");
    const auto plan = io::read_study(folder.path() / "study.yaml");
    REQUIRE(plan.cases.size() == 6);
    CHECK(plan.cases[1].labels == std::vector<std::string>{"8x4", "20"});
    CHECK(plan.cases[4].scene.grid.pipe->cells->across == 12);
    CHECK(plan.cases[4].scene.run.time_step.value_or(0) == test::relative(0.05));
    CHECK(plan.cases[4].scene.run.until == test::relative(2.0)); // two periods
}

TEST_CASE("mistakes of a study are shown with their places")
{
    const std::string unknown = refusal("name: s\nerror: womersly\n" + oscillating + "vary: { cels: [[8, 4]] }\n");
    CHECK(unknown.find("study.yaml:2:8") != std::string::npos);
    CHECK(unknown.find("'cels'") != std::string::npos);
    CHECK(refusal("name: s\nerror: self\n" + oscillating + "vary: { cells: [[8, 4, 2]] }\n").find("[across, along]") != std::string::npos);
    CHECK(refusal("name: s\nerror: self\n" + oscillating + "vary: { cells: [[9, 4]] }\n").find("multiple of 4") != std::string::npos);
    CHECK(refusal("name: s\nerror: self\n" + oscillating + "vary: { }\n").find("nothing to vary") != std::string::npos);
    CHECK(refusal("name: s\nerror: womersley\n" + oscillating + "vary: { cells: [[8, 4]] }\n").find("steps_per_period") !=
          std::string::npos);
}

TEST_CASE("the order comes out of the differences at three unequal steps")
{
    const auto value = [](double dt) { return 1.0 + 3.0 * std::pow(dt, 1.7); };
    const auto order = io::order_from_differences({0.3, 0.2, 0.05}, value(0.3) - value(0.2), value(0.2) - value(0.05));
    CHECK(order.value_or(0) == test::relative(1.7).epsilon(1e-6));
    CHECK_FALSE(io::order_from_differences({0.4, 0.2, 0.1}, 0.0, 1.0).has_value());
}

TEST_CASE("nobody beats the front, and orders compare runs that differ in one size only")
{
    const std::vector<io::StudyRun> runs{run_with(0.2, 0.1, 4e-2, 1, {0, 0}), run_with(0.1, 0.1, 1e-2, 8, {1, 0}),
                                         run_with(0.1, 0.05, 2e-2, 16, {1, 1})};
    CHECK(io::pareto_front(runs) == std::vector<bool>{true, true, false});
    const auto orders = io::observed_orders(runs, core::Communicator::self());
    CHECK(orders[1].h.value_or(0) == test::relative(2.0));
    CHECK_FALSE(orders[0].h.has_value());
    CHECK_FALSE(orders[2].h.has_value());
}
