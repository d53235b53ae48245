// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Layers of a bed: parts of spheres, its top, and how far down it moves.
#include "io/run/bed_metrics.hpp"
#include "tests/support/relative.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

TEST_CASE("below a plane through its middle lies half of a sphere, and what Archimedes says elsewhere")
{
    const double radius = 1.5e-3, whole = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    CHECK(io::volume_below(radius, 0.0) == test::relative(0.5 * whole).epsilon(1e-14));
    CHECK(io::volume_below(radius, 2 * radius) == test::relative(whole).epsilon(1e-14));
    CHECK(io::volume_below(radius, -radius) == 0.0);
    CHECK(io::volume_below(radius, -0.5 * radius) == test::relative(5.0 / 32.0 * whole).epsilon(1e-14)); // h^2 (3 r - h) / 4 at h = r / 2
}

TEST_CASE("a bed ends where grains fill 8 %, and moves down to where their speed falls below the bound")
{
    io::BedLayers layers;
    layers.lowest = -1.0;
    layers.thickness = 0.5;
    layers.room = std::vector<double>(6, 1.0);
    layers.solid = {0.6, 0.6, 0.6, 0.4, 0.06, 0.0};     // fractions 0.6 0.6 0.6 0.4 0.06 0
    layers.motion = {0.0, 0.0, 0.012, 0.08, 0.03, 0.0}; // speeds 0 0 0.02 0.2 0.5
    const io::MovingLayer moving = io::moving_layer(layers, 0.01);
    CHECK(moving.top == test::relative(0.75 + 0.5 * 0.32 / 0.34).epsilon(1e-12)); // between the middles 0.75 and 1.25
    CHECK(std::abs(moving.bottom) < 1e-12);                                       // between -0.25 and 0.25, half way from 0 to 0.02
    CHECK(io::moving_layer(layers, 0.3).thickness() == 0.0);
    layers.motion = {0.6, 0.6, 0.6, 0.4, 0.06, 0.0};
    CHECK(io::moving_layer(layers, 0.01).bottom == -1.0); // down to the floor
    layers.solid = layers.motion = {0, 0, 0, 0, 0, 0};
    CHECK(io::moving_layer(layers, 0.01).thickness() == 0.0);
}

TEST_CASE("transport over a bed needs to know what is above")
{
    using test_scene::problem_of, test_scene::with;
    const std::string scene = "name: s\ngrid: { box: { size: [9 mm, 9 mm, 9 mm], cells: [4, 4, 4] }, periodic: [x, y, z] }\n"
                              "particles:\n  - { name: S, count: 9, diameter: 1 mm, density: 2500 kg/m3 }\n"
                              "contact: { stiffness: 500 N/m }\nrun: { until: 1 s }\noutput: { grains: [transport] }\n";
    CHECK(problem_of(scene) == "7:19 'transport' needs 'gravity', which says what lies above a bed");
}
