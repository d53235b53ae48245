// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Blocks may touch but not lie in one another.
#include "core/grid/multi_block.hpp"

namespace core {

/// @throws ConfigError naming two cells of different blocks, one of which holds the centre of the other. Blocks that overlap by
///         less than half a cell pass.
void require_apart(const MultiBlock& grid);

} // namespace core
