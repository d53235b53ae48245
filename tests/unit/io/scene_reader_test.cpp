// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/io/scene_text.hpp"
#include <doctest/doctest.h>

using test_scene::problem_of;
using test_scene::problems_of;
using test_scene::with;

TEST_CASE("a good scene has no problems and SI values")
{
    const auto [scene, problems] = io::read_scene_text("scene.yaml", test_scene::good);
    CHECK(problems->text() == "");
    CHECK(scene.grid.pipe->diameter == 0.05);
    CHECK(scene.grid.pipe->chosen_cells() == io::PipeCells{16, 32});
    CHECK(scene.fluid->material.name == "water");
    CHECK(scene.fluid->drive->pressure_gradient == 33300.0);
    CHECK(scene.particles.at(0).diameter == 0.002);
    CHECK(scene.coupling == io::Coupling{});
}

TEST_CASE("every kind of mistake is shown at its line and column")
{
    CHECK(problem_of(with("length", "lenght")) == "3:28 unknown key 'lenght'");
    CHECK(problem_of(with("until: 1 s", "until: 1 s, until: 2 s")) == "11:20 'until' is given twice");
    CHECK(problem_of(with("[axial]", "axial")) == "4:13 this must be a list, and is a single value");
    CHECK(problem_of(with("count: 10", "count: ten")) == "9:23 'ten' is not a whole number");
    CHECK(problem_of(with("count: 10", "count: [1]")) == "9:23 a value is needed here, not a list");
    CHECK(problem_of(with("50 mm", "50")) == "3:21 '50' has no unit");
    CHECK(problem_of(with("50 mm", "50 s")) == "3:21 's' has the wrong dimension");
    CHECK(problem_of(with("50 mm", "50 mmm")) == "3:21 'mmm' is not a unit");
    CHECK(problem_of(with("50 mm", "-50 mm")) == "3:21 '-50 mm' is out of range");
    CHECK(problem_of(with("until: 1 s", "settle: 1 s")) == "11:1 'until' is missing");
    CHECK(problem_of(with("until: 1 s", "until: ")) == "11:8 'until' has no value");
    CHECK(problem_of(with("contact: { stiffness: 5 kN/m }", "contact: 5 kN/m")) ==
          "10:10 a group of keys is needed here, not a single value");
    CHECK(problem_of(with("[axial]", "[axail]")) == "4:14 'axail' is not one of the choices");
    CHECK(problem_of(with("drive: {", "oil: { density: 1 kg/m3 }\n  drive: {")) ==
          "7:3 'oil' would be a second <material>; one is possible");
}

TEST_CASE("broken YAML is shown at its place")
{
    CHECK(problem_of("name: [a\n").starts_with("2:1 YAML: "));
    CHECK(problem_of(test_scene::good + "---\nname: second\n") == "13:1 a second document begins here; a scene is one document");
    CHECK(problem_of(with("[axial]", "&a [*a]")).find("this alias refers to itself") != std::string::npos);
}

TEST_CASE("all mistakes of a file are shown at once, in the order of the text")
{
    auto text = with("50 mm", "50");
    text = with("2 mm", "2 kg", text);
    text = with("stiffness", "stifness", text);
    CHECK(problems_of(text) == std::vector<std::string>{"3:21 '50' has no unit", "9:37 'kg' has the wrong dimension",
                                                        "10:1 law: linear needs 'stiffness'", "10:12 unknown key 'stifness'"});
}

TEST_CASE("a problem shows the line, a caret below the place, and what to do")
{
    const auto reading = io::read_scene_text("scene.yaml", with("name: test", "nmae: tëst"));
    CHECK(reading.problems->text() == "scene.yaml:1:1: error: unknown key 'nmae'\n"
                                      "    1 | nmae: tëst\n"
                                      "      | ^\n"
                                      "      = did you mean 'name'?\n");
}

TEST_CASE("columns count characters, not bytes")
{
    CHECK(problem_of(with("name: S", "name: \"ö\", conut: 1")) == "9:18 unknown key 'conut'");
}

TEST_CASE("a slip of the fingers gets a suggestion, another word gets the choices")
{
    const std::vector<std::string> keys{"diameter", "length", "size"};
    CHECK(io::suggestion("diamter", keys) == "did you mean 'diameter'?");
    CHECK(io::suggestion("lenght", keys) == "did you mean 'length'?");
    CHECK(io::suggestion("colour", keys) == "choose from: diameter, length, size");
    CHECK(io::edit_distance("kitten", "sitting") == 3);
    CHECK(io::edit_distance("ab", "ba") == 1);
    CHECK(io::edit_distance("", "abc") == 3);
}

TEST_CASE("anchors and merge keys are expanded, and a key of its own wins over a merged one")
{
    const auto text = with("  - { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }\n",
                           "  - &s { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }\n"
                           "  - { <<: *s, name: L, diameter: 3 mm }\n");
    const auto [scene, problems] = io::read_scene_text("scene.yaml", text);
    CHECK(problems->text() == "");
    CHECK(scene.particles.at(1).name == "L");
    CHECK(scene.particles.at(1).diameter == 0.003);
    CHECK(scene.particles.at(1).count == 10);
}

TEST_CASE("overrides replace and add keys, and their mistakes have places")
{
    const auto [scene, problems] =
        io::read_scene_text("scene.yaml", test_scene::good,
                            {"grid.pipe.diameter=40 mm", "particles.S.count=7", "particles.0.diameter=1 mm", "output.results=every 1 ms"});
    CHECK(problems->text() == "");
    CHECK(scene.grid.pipe->diameter == 0.04);
    CHECK(scene.particles.at(0).count == 7);
    CHECK(scene.particles.at(0).diameter == 0.001);
    CHECK(scene.output.results == io::Interval{io::Interval::Clock::simulated, 0.001});

    CHECK(problem_of(test_scene::good, {"run.until=1"}) == "1:11 '1' has no unit");
    CHECK(problem_of(test_scene::good, {"run.utnil=1 s"}) == "1:5 unknown key 'utnil'");
    CHECK(problem_of(test_scene::good, {"particles.X.count=1"}) == "1:11 the list has no item 'X'");
    CHECK(problem_of(test_scene::good, {"run"}) == "1:1 an override is written key.path=value");
}
