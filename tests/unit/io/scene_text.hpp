// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Short scenes for tests, and where the problems of a text are.
#include "io/scene/scene_reader.hpp"
#include <fmt/format.h>
#include <string>
#include <vector>

namespace test_scene {

inline const std::string good = R"(name: test
grid:
  pipe: { diameter: 50 mm, length: 90 mm }
  periodic: [axial]
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  drive: { pressure_gradient: 33.3 kPa/m }
particles:
  - { name: S, count: 10, diameter: 2 mm, density: 2000 kg/m3 }
contact: { stiffness: 5 kN/m }
run: { until: 1 s }
)";

/// The good scene with one text replaced by another.
inline std::string with(const std::string& old_text, const std::string& new_text, std::string scene = good)
{
    return scene.replace(scene.find(old_text), old_text.size(), new_text);
}

/// "line:column message" of every problem.
inline std::vector<std::string> problems_of(const std::string& text, const std::vector<std::string>& overrides = {})
{
    std::vector<std::string> all;
    for (const auto& problem : io::read_scene_text("scene.yaml", text, overrides).problems->sorted())
        all.push_back(fmt::format("{}:{} {}", problem.mark.line, problem.mark.column, problem.message));
    return all;
}

/// The same as one text, a problem on each line.
inline std::string problem_of(const std::string& text, const std::vector<std::string>& overrides = {})
{
    std::string all;
    for (const auto& problem : problems_of(text, overrides)) all += (all.empty() ? "" : "\n") + problem;
    return all;
}

} // namespace test_scene
