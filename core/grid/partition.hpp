// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which rank owns which block.
#include "core/grid/extents.hpp"
#include <span>
#include <vector>

namespace core {

/// Blocks in consecutive runs of nearly equal numbers of cells; blocks themselves never depend on the number of ranks.
/// @return owner of each block. Ranks beyond the number of blocks own none.
[[nodiscard]] std::vector<int> partition(std::span<const Extents> cells, int ranks);

} // namespace core
