// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How good the cells of a grid are, and where the worst ones lie.
#include "core/grid/topology.hpp"

namespace core {

struct WorstCell {
    double value = 0;
    BlockId block = -1;
    Index3 cell;
};

struct GridQuality {
    WorstCell jacobian;     ///< smallest Jacobian at a corner over the product of its edges; 1 for a brick [-]
    WorstCell skewness;     ///< largest deviation of the angle between two edges from a right angle [rad]
    WorstCell aspect_ratio; ///< largest ratio of a cell's mean edges [-]
    WorstCell growth;       ///< largest ratio of the sizes of neighbours along a grid line, across sides of blocks too [-]
};

[[nodiscard]] GridQuality quality_of(const std::vector<Vertices>& blocks, const Topology& topology);

} // namespace core
