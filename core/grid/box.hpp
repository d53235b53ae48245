// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Boxes cut into blocks, and any smooth map of them.
#include "core/grid/multi_block.hpp"
#include <functional>

namespace core {

struct Box {
    Vec3 low = Vec3::Zero(), high = Vec3::Ones(); ///< corners [m]
    Extents cells{8, 8, 8};                       ///< of the whole box
    Extents blocks{1, 1, 1};                      ///< blocks along each axis
    std::array<bool, 3> periodic{false, false, false};
};

/// Uniform box. Boundary names: x_low, x_high, y_low, ... .
/// @param map  Moves every vertex; must keep periodic sides congruent.
/// @throws ConfigError if the cells do not divide into the blocks.
[[nodiscard]] MultiBlock make_box(
    const Box& box, const std::function<Vec3(const Vec3&)>& map = [](const Vec3& x) { return x; });

} // namespace core
