// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Elliptic generation for all blocks of a grid at once: what is asked at boundaries reaches every block that it concerns.
#include "core/grid/elliptic.hpp"
#include <string>

namespace core {

/// Size and growth of the cells at a boundary.
struct BoundarySpacing {
    std::string boundary;
    double first_cell = 0; ///< [m]
    double growth = 1.2;
};

struct BlockAttraction {
    BlockId block = 0;
    Attraction attraction;
};

struct EllipticGrid {
    std::vector<BoundarySpacing> spacings;
    std::vector<BlockAttraction> attractions;
    std::vector<std::string> smoothed; ///< plane boundaries whose own vertices are generated too
    Curvature curvature = Curvature::cubic_spline;
};

/// Replaces the inner vertices of all blocks by elliptic ones. A spacing goes on through the sides of blocks along the
/// boundary, so that sides that met still meet; on those sides the vertices move along their lines.
/// @return one result for each block.
/// @throws ConfigError for a boundary or block that does not exist, or as make_elliptic() with the number of the block.
std::vector<EllipticResult> make_elliptic(MultiBlock& grid, const EllipticGrid& wanted);

} // namespace core
