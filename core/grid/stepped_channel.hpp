// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A channel along x whose floor steps down: a shallow part and a deep one. With periodic ends, a channel with a trench.
#include "core/grid/multi_block.hpp"
#include <optional>

namespace core {

struct SteppedChannel {
    double shallow_length = 0.1, deep_length = 0.3; ///< along x [m]
    double height = 0.05;                           ///< of the shallow part [m]
    double step = 0.05;                             ///< by which the deep part is deeper [m]
    double width = 0.1;                             ///< along z [m]
    std::array<int, 2> cells_along{8, 24};          ///< of the shallow and the deep part
    std::array<int, 2> cells_up{8, 8};              ///< over the step and over the height
    int cells_across = 8;
    std::optional<int> deep_cells_up;      ///< over the height in the deep part; without it as in the shallow one
    std::optional<int> deep_cells_across;  ///< of the deep part
    std::array<int, 2> blocks_along{1, 1}; ///< of the shallow and the deep part
    int blocks_across = 1;
    bool periodic_along = false, periodic_across = false;
};

/// Where the two parts meet their points need not match. The floor of the deep part is y = 0. Boundary names: x_low, x_high,
/// y_low, y_high, z_low, z_high as of a box, and step.
/// @throws ConfigError if a length is not positive or cells do not divide into blocks.
[[nodiscard]] MultiBlock make_stepped_channel(const SteppedChannel& channel);

} // namespace core
