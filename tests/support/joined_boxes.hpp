// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Boxes side by side whose points need not match, displaced and turned as one.
#include "core/grid/box.hpp"
#include "core/grid/touching_sides.hpp"
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace test {

/// Puts the blocks of some boxes together and finds the sides that touch.
/// @param map  Displaces the vertices.
[[nodiscard]] inline core::MultiBlock joined(const std::vector<core::Box>& boxes, const std::vector<core::Vec3>& periods,
                                             const std::function<core::Vec3(const core::Vec3&)>& map)
{
    core::MultiBlock grid;
    grid.periods = periods;
    for (const core::Box& box : boxes)
        for (auto& block : core::make_box(box, map).blocks) grid.blocks.push_back(std::move(block));
    for (const core::TouchingSides& t : core::touching_sides(grid, core::match_sides(grid))) grid.contacts.push_back(t);
    return grid;
}

/// Cells of the first and the second half of a box.
struct Halves {
    core::Extents first, second;
};

/// A periodic box of side 2 pi, wavy and turned, whose two halves along x have points of their own: two interfaces, one of them
/// through the period.
[[nodiscard]] inline core::MultiBlock wavy_halves(const Halves& cells, double amplitude, double turn_degrees)
{
    const double pi = std::numbers::pi;
    const core::Mat3 turn = Eigen::AngleAxisd(turn_degrees * pi / 180, core::Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    const auto map = [=](const core::Vec3& x) {
        const core::Vec3 wave(std::sin(x.y()) * std::cos(x.z()), std::sin(x.x()), std::sin(x.x() + x.y()));
        return core::Vec3(turn * (x + amplitude * wave));
    };
    const core::Box first{{0, 0, 0}, {pi, 2 * pi, 2 * pi}, cells.first, {1, 1, 1}, {}};
    const core::Box second{{pi, 0, 0}, {2 * pi, 2 * pi, 2 * pi}, cells.second, {1, 1, 1}, {}};
    std::vector<core::Vec3> periods;
    for (int axis = 0; axis < 3; ++axis) periods.emplace_back(2 * pi * turn.col(axis));
    return joined({first, second}, periods, map);
}

/// Two boxes on one, each with points of its own, so that three sides meet along a line.
/// @param curvature  Of the sides [m].
[[nodiscard]] inline core::MultiBlock two_on_one(double curvature)
{
    const core::Box below{{0, 0, 0}, {2, 1, 1}, {7, 3, 4}, {1, 1, 1}, {}}, left{{0, 1, 0}, {0.8, 2, 1}, {4, 5, 3}, {1, 1, 1}, {}},
        right{{0.8, 1, 0}, {2, 2, 1}, {5, 5, 5}, {1, 1, 1}, {}};
    return joined({below, left, right}, {}, [=](const core::Vec3& x) {
        return core::Vec3(x + core::Vec3(0.1 * x.y() * x.z(), 0.3 * x.x() + curvature * std::sin(3 * x.x()) * (1 + x.z()), 0));
    });
}

} // namespace test
