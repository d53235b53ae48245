// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/contact_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using test_scene::problem_of, test_scene::with;

namespace {

/// The good scene with a second species, twice as large, and other contacts.
std::string contacts(const std::string& keys)
{
    const std::string two = "  - { name: L, count: 10, diameter: 4 mm, density: 2000 kg/m3 }\ncontact: { " + keys + " }";
    return with("contact: { stiffness: 5 kN/m }", two);
}

physics::ParticleParameters parameters(const std::string& keys) { return io::particle_parameters(test::scene_from_text(contacts(keys))); }

} // namespace

TEST_CASE("names in contacts exist, and each pair and each material is given once")
{
    CHECK(problem_of(contacts("stiffness: 1 N/m, pairs: [{ between: [S, l], friction: 0 }]")) == "11:49 nothing is made of 'l'");
    CHECK(problem_of(contacts("stiffness: 1 N/m, pairs: [{ between: [S, wall] }, { between: [wall, S] }]")) ==
          "11:73 the pair of 'wall' and 'S' is given twice");
    CHECK(problem_of(contacts("stiffness: 1 N/m, pairs: [{ between: [wall, wall] }]")) == "11:49 walls do not meet each other");
    CHECK(problem_of(contacts("stiffness: 1 N/m, pairs: [{ between: S }]")) == "11:49 two names [a, b] are needed here");
    const std::string steel = "{ of: S, young_modulus: 1 GPa, poisson_ratio: 0.3 }";
    CHECK(problem_of(contacts("law: hertz, young_modulus: 1 GPa, poisson_ratio: 0.3, impact_speed: 1 m/s, materials: [" + steel + ", " +
                              steel + "]"))
              .ends_with("the material of 'S' is given twice"));
}

TEST_CASE("particles and walls of one material are named by it")
{
    const auto scene = [](const std::string& keys, const std::string& wall) {
        return with("contact: { stiffness: 5 kN/m }",
                    "  - { name: L, material: glass, count: 10, diameter: 4 mm, density: 2000 kg/m3 }\ncontact: { " + keys +
                        " }\nwalls: [{ name: drum, plane: { point: [0 m, 0 m, 0 m], normal: y }" + wall + " }]");
    };
    const std::string steel = ", material: steel";
    CHECK(problem_of(scene("stiffness: 1 N/m, pairs: [{ between: [glass, steel] }, { between: [glass, glass] }]", steel)) == "");
    CHECK(problem_of(scene("stiffness: 1 N/m, pairs: [{ between: [L, steel] }]", steel)) == "11:49 'L' is of the material 'glass'");
    CHECK(problem_of(scene("stiffness: 1 N/m, pairs: [{ between: [S, drum] }]", "")) == "11:49 nothing is made of 'drum'");
    CHECK(problem_of(scene("stiffness: 1 N/m, pairs: [{ between: [wall, steel] }]", steel)) == "11:49 walls do not meet each other");
    CHECK(problem_of(scene("pairs: [{ between: [S, S], stiffness: 1 N/m }, { between: [S, glass], stiffness: 1 N/m }, { between: [S, "
                           "wall], stiffness: 1 N/m }]",
                           steel)) == "11:1 law: linear needs 'stiffness' between 'S' and 'steel'");
    CHECK(problem_of(scene("stiffness: 1 N/m, sides: [{ at: wall, material: steel }, { at: wall, material: glass }]", "")) ==
          "11:75 the material of 'wall' is given twice");
    CHECK(problem_of(scene("stiffness: 1 N/m, sides: [{ at: x_low, material: steel }]", "")) ==
          "11:44 the grid repeats along x: it has no boundary 'x_low'");

    const auto p = io::particle_parameters(test::scene_from_text(
        scene("stiffness: 5 kN/m, sides: [{ at: wall, material: glass }], pairs: [{ between: [glass, steel], friction: 0.1 }, { between: "
              "[glass, glass], friction: 0.2 }, { between: [S, glass], friction: 0.3 }]",
              steel)));
    CHECK(p.wall_materials == 3); // wall, glass, steel
    REQUIRE(p.walls.size() == 6); // of each S, L
    CHECK(p.walls[0] == p.walls[1]);
    CHECK(p.walls[2].friction == 0.3);
    CHECK(p.walls[3].friction == 0.2);
    CHECK(p.walls[4].friction == 0.4);
    CHECK(p.walls[5].friction == 0.1);
    CHECK(p.pairs[1].friction == 0.3);
    CHECK(p.pairs[3].friction == 0.2);
}

TEST_CASE("each law has the constants that it needs and no others")
{
    CHECK(problem_of(contacts("friction: 0.3")) == "11:1 law: linear needs 'stiffness'");
    CHECK(problem_of(contacts("stiffness: 1 N/m, collision_time: 1 ms")) == "11:46 'collision_time' excludes 'stiffness'");
    CHECK(problem_of(contacts("law: hertz, impact_speed: 1 m/s")) == "11:1 law: hertz needs 'young_modulus' and 'poisson_ratio' of 'L'");
    CHECK(problem_of(contacts("stiffness: 1 N/m, young_modulus: 1 MPa")) == "11:45 'young_modulus' means nothing for law: linear");
    CHECK(problem_of(contacts("law: hertz, young_modulus: 1 MPa, poisson_ratio: 0.2")) ==
          "11:1 law: hertz needs 'impact_speed' where nothing moves and nothing falls");
    CHECK(problem_of(contacts("law: hertz, young_modulus: 1 MPa, poisson_ratio: 0.2, impact_speed: 1 m/s, "
                              "pairs: [{ between: [S, wall], law: linear, stiffness: 1 kN/m }]")) == "");
    CHECK(problem_of(contacts("stiffness: 1 N/m, restitution: 0")) != "");
}

TEST_CASE("contacts that differ fill tables and others stay single")
{
    const auto same = parameters("stiffness: 5 kN/m, friction: 0.2");
    CHECK(same.pairs.size() == 1);
    CHECK(same.walls.size() == 1);
    const auto p = parameters("stiffness: 5 kN/m, friction: 0.2, pairs: [{ between: [L, S], friction: 0.7, restitution: 0.3 }, "
                              "{ between: [wall, L], rolling_friction: 0.1 }]");
    REQUIRE(p.pairs.size() == 4);
    CHECK(p.pairs[0].friction == 0.2);
    CHECK(p.pairs[1].friction == 0.7);
    CHECK(p.pairs[2] == p.pairs[1]);
    CHECK(p.pairs[1].restitution == 0.3);
    CHECK(p.walls[0].rolling_friction == 0.0);
    CHECK(p.walls[1].rolling_friction == 0.1);
    CHECK(p.walls[1].friction == 0.2);
}

TEST_CASE("materials give the effective moduli of their contacts")
{
    const auto p = parameters("law: hertz, young_modulus: 70 GPa, poisson_ratio: 0.25, impact_speed: 2 m/s, "
                              "materials: [{ of: wall, young_modulus: 1 GPa, poisson_ratio: 0.4 }]");
    REQUIRE(p.pairs.size() == 1);
    CHECK(p.pairs[0].young_modulus == test::relative(7e10 / (2 * (1 - 0.0625))).epsilon(1e-14));
    CHECK(p.pairs[0].shear_modulus == test::relative(7e10 / (4 * 1.75 * 1.25)).epsilon(1e-14));
    CHECK(p.walls[0].young_modulus == test::relative(1 / (0.9375 / 7e10 + 0.84 / 1e9)).epsilon(1e-14));
    CHECK(p.walls[0].impact_speed == 2.0);
}

TEST_CASE("a collision time gives each pair of species the stiffness of its mass")
{
    const auto p = parameters("collision_time: 0.1 ms, restitution: 1");
    const double mass = std::numbers::pi / 6 * 8e-9 * 2000; // of S; L weighs eight times as much
    const double rate2 = std::pow(std::numbers::pi / 1e-4, 2);
    CHECK(p.pairs[0].stiffness == test::relative(mass / 2 * rate2).epsilon(1e-12));
    CHECK(p.pairs[1].stiffness == test::relative(mass * 8 / 9 * rate2).epsilon(1e-12));
    CHECK(p.walls[1].stiffness == test::relative(mass * 8 * rate2).epsilon(1e-12));
}

TEST_CASE("Hertz' springs are made for the fastest impacts of the scene")
{
    const std::string keys = "law: hertz, young_modulus: 1 MPa, poisson_ratio: 0.2";
    const std::string falling = contacts(keys) + "gravity: { direction: -y, magnitude: 10 m/s2 }\n";
    CHECK(io::impact_speed(test::scene_from_text(falling)) == test::relative(1.0).epsilon(1e-12)); // 50 mm
    CHECK(io::impact_speed(test::scene_from_text(contacts(keys + ", impact_speed: 3 m/s"))) == 3.0);
}
