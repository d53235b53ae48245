// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cells of a given height at sides of a block: lines spaced on the sides that leave them, and control functions within.
#include "core/grid/control_functions.hpp"

namespace core {

/// What is wanted at the two ends of the lines along an axis.
struct WallEnds {
    std::optional<WallSpacing> low, high;
    [[nodiscard]] bool any() const { return low || high; }
};

/// Moves the vertices of all lines that leave sides with wanted spacing along themselves, so that they have it; vertices on
/// the sides of the block remain on them.
/// @throws ConfigError naming the line if the spacing is impossible.
void respace_lines(Vertices& block, const std::vector<WallSpacing>& wanted);

/// The control functions that hold such lines inside the block.
class WallLayers {
public:
    /// @param block  Its lines have been spaced.
    WallLayers(const Vertices& block, const std::vector<WallSpacing>& wanted, Curvature kind);

    /// Corrects the factors by what the heights of the first cells are now. @return largest relative error of the heights.
    double correct(const Vertices& block);
    /// Adds the factors that hold the layers, times `share`.
    void add_factors(double share, ControlFunctions& control) const;

private:
    [[nodiscard]] double correct(const Vertices& block, const WallSpacing& wall);

    std::array<WallEnds, 3> ends_;
    std::array<Array3<double>, 3> factor_;     ///< of the straight lines that have the spacing, along each axis with layers
    std::array<Array3<double>, 6> correction_; ///< at the vertices of each side with spacing: logarithm of a factor of the first cell
};

} // namespace core
