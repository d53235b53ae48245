// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The geometry of a block as plain numbers, for results and pictures.
#include "core/grid/extents.hpp"
#include <vector>

namespace io {

struct BlockNodes {
    core::Extents cells;
    std::vector<double> points; ///< 3 for each node, (ni + 1)(nj + 1)(nk + 1) nodes, i fastest [m]
};

/// Number of a node in the order of `points`.
[[nodiscard]] inline std::ptrdiff_t node_number(core::Extents cells, core::Index3 node)
{
    return (std::ptrdiff_t(node.k) * (cells.nj + 1) + node.j) * (cells.ni + 1) + node.i;
}

} // namespace io
