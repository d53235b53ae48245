// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Blocks of a grid file as a multi-block grid: right-handed, in metres, every side that meets no other with its name.
#include "core/grid/multi_block.hpp"
#include "io/scene/grid_shapes.hpp"

namespace io {

/// A left-handed block is turned by counting its third index from the other end; names of sides stay those of the file.
/// @param periodic  Axes along which the domain repeats.
/// @throws core::ConfigError if the file cannot be read, or naming all sides that have no name, or a name that fits no side.
[[nodiscard]] core::MultiBlock import_blocks(const ImportedGrid& grid, const std::array<bool, 3>& periodic,
                                             const std::optional<core::PeriodicTurn>& turn = std::nullopt);

} // namespace io
