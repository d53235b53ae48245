// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sizes of cells along a line that start small at its ends and grow towards its middle.
#include <optional>
#include <vector>

namespace core {

/// What is asked of the ends of a line.
struct EndSpacing {
    std::optional<double> low, high; ///< size of the cell at each end, in the unit of the length
    double growth = 1.2;             ///< largest ratio of neighbours
};

/// Shares of the length at the cells + 1 points: geometric growth from the ends to equal cells between.
/// @throws ConfigError if cells that grow this slowly do not fill the length.
[[nodiscard]] std::vector<double> spaced(int cells, double length, const EndSpacing& ends);

} // namespace core
