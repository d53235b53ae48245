// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Mistakes in scenes that a turn carries onto themselves.
#include "io/build/grid_builder.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <doctest/doctest.h>
#include <numbers>

using test_scene::problem_of;
using test_scene::with;

namespace {

const std::string sector = R"(name: sector
grid:
  annulus: { inner_diameter: 1 m, outer_diameter: 2 m, length: 1 m, cells_around: 4, blocks_around: 1, angle: 45 degrees }
  periodic: [axial]
  turn: { angle: 45 degrees }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  boundaries:
    - { at: inner, spin: { rate: 1 rad/s } }
run: { until: 1 s }
)";

std::string instead(const std::string& old_text, const std::string& text) { return problem_of(with(old_text, text, sector)); }

} // namespace

TEST_CASE("the sector of an annulus is joined to itself by a turn, or has two more boundaries")
{
    CHECK(problem_of(sector).empty());
    const auto names = [](const std::string& text) {
        core::MultiBlock blocks = io::make_blocks(io::read_scene_text("scene.yaml", text).scene.grid);
        return io::boundary_names(core::match_sides(blocks));
    };
    CHECK(names(sector) == std::vector<std::string>{"inner", "outer"});
    CHECK(names(with("  turn: { angle: 45 degrees }\n", "", sector)) ==
          std::vector<std::string>{"angle_high", "angle_low", "inner", "outer"});
}

TEST_CASE("turns that join no sides are refused, or sides whose points do not match")
{
    CHECK(instead("turn: { angle: 45", "turn: { angle: 40")
              .starts_with("5:3 a turn of 40 degrees about (1 0 0) through (0 0 0) m lays no side"));
    CHECK(instead("turn: { angle: 45", "turn: { angle: 0") == "5:18 the angle of a turn lies between 0 and 360 degrees");
    const std::string quarter =
        with("annulus: { inner_diameter: 1 m, outer_diameter: 2 m, length: 1 m, cells_around: 4, blocks_around: 1, "
             "angle: 45 degrees }",
             "box: { size: [1 m, 1 m, 1 m], cells: [4, 4, 4] }",
             with("turn: { angle: 45", "turn: { angle: 90", with("[axial]", "[x]", with("at: inner, spin", "at: x_low, spin", sector))));
    CHECK(problem_of(with("at: x_low, spin: { rate: 1 rad/s }", "at: y_high", quarter)).empty());
    CHECK(
        problem_of(with("at: x_low, spin: { rate: 1 rad/s }", "at: y_high", with("cells: [4, 4, 4]", "cells: [4, 4, 5]", quarter))) ==
        "5:3 a turn of 90 degrees about (1 0 0) through (0 0 0) m lays side k_low of block 0 on side j_low of block 0, but their points do "
        "not match: give both the same points");
}

TEST_CASE("what a turn does not carry onto itself is refused")
{
    CHECK(instead("spin: { rate: 1 rad/s }", "spin: { rate: 1 rad/s, axis: +y }")
              .ends_with("9:20 the wall spins about another axis than that of the turn of the grid"));
    CHECK(instead("at: inner, spin: { rate: 1 rad/s }", "at: inner, velocity: [0 m/s, 1 m/s, 0 m/s]")
              .ends_with("9:30 after the turn of the grid this velocity points another way"));
    CHECK(instead("spin: { rate: 1 rad/s }", "kind: slip, spin: { rate: 1 rad/s }") == "9:32 'spin' means nothing for kind: slip");
    CHECK(instead("turn: { angle: 45 degrees }", "turn: { angle: 45 degrees, axis: +y }").find("across the axis of its turn") !=
          std::string::npos);
    const std::string grains =
        "particles:\n  - { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }\ncontact: { stiffness: 5 kN/m, walls: faces }\nrun:";
    CHECK(instead("run:", grains) == "5:3 particles cannot pass sides that are joined by a turn yet");
}
