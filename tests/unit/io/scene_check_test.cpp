// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Mistakes that several keys make together.
#include "tests/unit/io/scene_text.hpp"
#include <doctest/doctest.h>

using test_scene::problem_of;
using test_scene::with;

TEST_CASE("cells must divide into blocks, and are given once")
{
    CHECK(problem_of(with("90 mm", "90 mm, blocks_along: 5")) == "3:57 32 cells along the pipe do not divide into 5 blocks");
    CHECK(problem_of(with("90 mm", "90 mm, cells: { across: 14, along: 32 }")) == "3:60 14 cells across are not a multiple of 4");
    CHECK(problem_of(with("90 mm", "90 mm, size: small, cells: { across: 12, along: 32 }")) == "3:56 'cells' excludes 'size'");
}

TEST_CASE("the named sizes of a pipe have about 2, 6 and 20 thousand cells that divide into four blocks")
{
    CHECK(io::cells_of(io::PipeSize::small).total() == 2160);
    CHECK(io::cells_of(io::PipeSize::medium).total() == 6144);
    CHECK(io::cells_of(io::PipeSize::large).total() == 20736);
    for (auto size : {io::PipeSize::small, io::PipeSize::medium, io::PipeSize::large}) {
        CHECK(io::cells_of(size).across % 4 == 0);
        CHECK(io::cells_of(size).along % 4 == 0);
    }
}

TEST_CASE("a drive needs a periodic axis, and one way to change")
{
    CHECK(problem_of(with("periodic: [axial]", "periodic: []")) == "7:3 the drive acts along x, which is not periodic");
    CHECK(problem_of(with("33.3 kPa/m", "33.3 kPa/m, frequency: 1 Hz, reverse_at: { axis_speed: 1 m/s }")) ==
          "7:60 'reverse_at' excludes 'frequency'");
    CHECK(problem_of(with("[axial]", "[y]")) == "4:13 a pipe repeats only along its axis\n"
                                                "7:3 the drive acts along x, which is not periodic");
}

TEST_CASE("the blocks of a box divide its cells")
{
    CHECK(problem_of(with("pipe: { diameter: 50 mm, length: 90 mm }",
                          "box: { size: [9 mm, 9 mm, 9 mm], cells: [8, 8, 8], blocks: [1, 3, 1] }", with("[axial]", "[x]"))) ==
          "3:62 8 cells along y do not divide into 3 blocks");
}

TEST_CASE("boundaries have names that the grid knows, and the keys of their kind")
{
    const auto boundary = [](const std::string& text) { return with("  water:", "  boundaries:\n    - { " + text + " }\n  water:"); };
    CHECK(problem_of(boundary("at: walls, kind: slip")) == "7:13 the grid has no boundary 'walls'");
    CHECK(problem_of(boundary("at: x_low, kind: slip")) == "7:13 the grid repeats along x: it has no boundary 'x_low'");
    CHECK(problem_of(boundary("at: wall, kind: slip, pressure: 1 Pa")) == "7:41 'pressure' means nothing for kind: slip");
    CHECK(problem_of(boundary("at: wall, kind: inflow")) == "7:7 an inflow needs 'velocity'");
}

TEST_CASE("walls move along themselves, inflows let something in, and what flows in flows out")
{
    const std::string channel = R"(name: channel
grid: { box: { size: [1 m, 1 m, 1 m], cells: [4, 4, 4], blocks: [2, 1, 1] }, periodic: [z] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  boundaries:
    - { at: x_low, kind: inflow, velocity: [1 m/s, 0 m/s, 0 m/s] }
    - { at: x_high, kind: outflow }
run: { until: 1 s }
)";
    const auto instead = [&](const std::string& old_text, const std::string& text) { return problem_of(with(old_text, text, channel)); };
    CHECK(instead("1 m/s, 0 m/s", "1 m/s, 3 m/s").empty());
    CHECK(instead("[1 m/s, 0 m/s", "[0 m/s, 1 m/s") == "6:44 nothing flows in through 'x_low': the velocity lies along it");
    CHECK(instead("kind: inflow", "kind: wall") ==
          "6:42 the wall 'x_low' would move through the fluid at cell (0, 0, 0) at side i_low of block 0");
    CHECK(instead("kind: outflow", "kind: slip") == "6:26 1 m3/s more flow into the domain than the other way, and no boundary gives way");
    CHECK(instead("kind: outflow", "kind: inflow, velocity: [1 m/s, 0 m/s, 0 m/s]").empty());
    CHECK(instead("kind: outflow", "kind: inflow, velocity: [3 m/s, 0 m/s, 0 m/s]") ==
          "6:26 2 m3/s more flow out of the domain than the other way, and no boundary gives way");
    CHECK(instead("x_high, kind: outflow", "y_high, velocity: [1 m/s, 0 m/s, 0 m/s]").starts_with("6:26 1 m3/s more flow into"));
    CHECK(instead("at: x_high", "at: z_high") == "7:13 the grid repeats along z: it has no boundary 'z_high'");
    CHECK(instead("at: x_high", "at: x_low") == "7:13 'x_low' is given twice");
    CHECK(instead("size: [1 m", "size: [1e-8 m").starts_with("2:1 side i_low of block 0 meets blocks 0 and 1"));
}

TEST_CASE("scalars have names of their own and boundaries that exist; turbulence has a speed and a viscosity")
{
    const auto fluid = [](const std::string& text) { return with("  water:", "  " + text + "\n  water:"); };
    CHECK(problem_of(fluid("scalars: [ { name: dye }, { name: dye } ]")) == "6:37 the name 'dye' is taken");
    CHECK(problem_of(fluid("scalars: [ { name: pressure } ]")) == "6:22 the name 'pressure' is taken");
    CHECK(problem_of(fluid("scalars: [ { name: dye, entering: [ { at: inlet, value: 1 } ] } ]"))
              .ends_with("the grid has no boundary 'inlet'"));
    CHECK(problem_of(fluid("turbulence: { model: k-epsilon }")) == "6:3 turbulence needs 'speed' where nothing flows in");
    CHECK(problem_of(fluid("turbulence: { model: k-omega, speed: 1 m/s }")) != "");
    CHECK(problem_of(fluid("turbulence: { model: none }")) == "");
    CHECK(problem_of(fluid("turbulence: { model: abe-kondoh-nagano, speed: 1 m/s }")) == "");
    CHECK(problem_of(fluid("turbulence: { model: abe-kondoh-nagano, speed: 1 m/s, roughness: 1 mm }"))
              .ends_with("walls that are resolved are smooth"));
}

TEST_CASE("particles need contact, names of their own, and room")
{
    CHECK(problem_of(with("contact: { stiffness: 5 kN/m }\n", "")) == "8:1 particles need 'contact'");
    CHECK(problem_of(with("contact", "  - { name: S, count: 1, diameter: 1 mm, density: 1 kg/m3 }\ncontact")) ==
          "10:13 two species are named 'S'");
    CHECK(problem_of(with("2 mm", "60 mm")).starts_with("9:37 the particles are larger than the domain"));
    // 30 mm high centres of 2 mm spheres in a 50 mm pipe: the wall is at 25 mm.
    CHECK(problem_of(with("2 mm", "2 mm, initial: { high: [0.09 m, 30 mm, 0 m] }")) == "9:60 particles would be outside the domain");
    CHECK(problem_of(with("2 mm", "2 mm, initial: { low: [1 mm, 9 mm, 0 m], high: [2 mm, 8 mm, 0 m] }")) ==
          "9:59 'low' is above 'high' along y");
    // 20,000 spheres of 2 mm have 8.4e-5 m3, 47 % of the pipe's 1.77e-4 m3.
    CHECK(problem_of(with("count: 10,", "count: 20000,")) == "9:23 the particles would fill 47 % of their region");
}

TEST_CASE("finite volumes carry a fluid alone and between particles")
{
    CHECK(problem_of(with("  water:", "  advection: finite_volume\n  water:")).empty());
    CHECK(problem_of(with("  water:", "  advection: upwind\n  water:")) == "6:14 'upwind' is not one of the choices");
}

TEST_CASE("keys that would do nothing are mistakes")
{
    const auto particles = "particles:\n  - { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }\n";
    CHECK(problem_of(with(particles, "")) == "8:1 'contact' does nothing without 'particles'");
    CHECK(problem_of(with("run:", "coupling: {}\nrun:", with(particles, ""))) ==
          "8:1 'contact' does nothing without 'particles'\n9:1 'coupling' needs both 'fluid' and 'particles'");
    CHECK(problem_of(with("until: 1 s", "until: 1 s, time_step: 2 s")) == "11:31 the time step is longer than the run");
    CHECK(problem_of(with("run:", "coupling: { filter: 20 d }\nrun:")) == "11:21 a filter of 0.04 m is wider than half of the domain");
    CHECK(problem_of("name: empty\ngrid: { pipe: { diameter: 1 m, length: 1 m } }\nrun: { until: 1 s }\n") ==
          "1:1 the scene has neither 'fluid' nor 'particles'");
}
