// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is in a picture: plain data that a renderer on another thread may keep.
#include "core/base/vec3.hpp"
#include "io/picture/colour_map.hpp"
#include <optional>
#include <string>
#include <vector>

namespace io {

struct Camera {
    core::Vec3 eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0}; ///< [m]
    double angle = 26.0;                                   ///< vertical field of view [degrees]
};

/// A camera that looks along `direction` and has the box (low, high) just in view.
/// @param aspect  width over height of the picture
[[nodiscard]] Camera fit_camera(const core::Vec3& low, const core::Vec3& high, const core::Vec3& direction, double aspect);

struct Sphere {
    float x = 0, y = 0, z = 0, radius = 0; ///< [m]
    Colour colour{};
};

/// Translucent walls: triangles over shared points.
struct Surface {
    std::vector<std::array<float, 3>> points; ///< [m]
    std::vector<std::array<int, 3>> triangles;
};

/// A face with one colour: what cross-sections of a field are made of.
struct ColouredQuad {
    std::array<std::array<float, 3>, 4> corners; ///< in order around the face [m]
    Colour colour{};
};

struct LegendEntry {
    Colour colour{};
    std::string text;
};

/// Bar of sequential_colour from `low` to `high`.
struct ColourBar {
    std::string title; ///< quantity and unit
    double low = 0.0, high = 1.0;
};

struct Caption {
    std::string title;  ///< upper left
    std::string detail; ///< below the title: time and the like
    std::vector<LegendEntry> legend;
    std::optional<ColourBar> bar;
};

struct PictureScene {
    std::vector<Sphere> spheres;
    std::vector<Surface> walls;
    std::vector<ColouredQuad> quads;
    Camera camera;
    Caption caption;
};

} // namespace io
