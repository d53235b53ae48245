// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes that tests write down as users do.
#include "io/scene/scene_reader.hpp"
#include <doctest/doctest.h>

namespace test {

/// The scene must be without mistakes.
[[nodiscard]] inline io::Scene scene_from_text(const std::string& text)
{
    const io::SceneReading reading = io::read_scene_text("scene.yaml", text);
    INFO(reading.problems->text());
    REQUIRE(reading.problems->empty());
    return reading.scene;
}

/// Heavy and light grains in a short periodic pipe of oil.
/// @param drive, coupling  Keys of these two maps.
[[nodiscard]] inline io::Scene small_pipe(const std::string& drive, const std::string& coupling)
{
    return scene_from_text(R"(name: small pipe
grid: { pipe: { diameter: 20 mm, length: 24 mm, cells: { across: 12, along: 12 }, blocks_along: 2 }, periodic: [axial] }
fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
  drive: { )" + drive + R"( }
gravity: { direction: -y }
particles:
  - { name: heavy, count: 60, diameter: 2 mm, density: 2000 kg/m3 }
  - { name: light, count: 60, diameter: 1.5 mm, density: 1100 kg/m3 }
contact: { stiffness: 500 N/m, restitution: 0.6, friction: 0.4 }
coupling: { )" + coupling + R"( }
run: { settle: 50 ms, until: 1 s, time_step: 1 ms }
)");
}

} // namespace test
