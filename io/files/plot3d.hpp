// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Grids in the Plot3D format: text or binary, one block or many, as Fortran or C programs write them.
#include "core/grid/multi_block.hpp"
#include <filesystem>

namespace io {

struct Plot3d {
    std::vector<core::Vertices> blocks; ///< [m] if the file is in metres
    std::string form;                   ///< "text", "binary, 64 bits, little-endian, records", ...
};

/// Reads a three-dimensional grid. How it was written follows from its size: numbers of 32 or 64 bits, either order of bytes,
/// with or without Fortran's record marks, the number of blocks or the blanking.
/// @throws core::ConfigError if the file fits none of these, is torn, has points that are not finite, or blanked points.
[[nodiscard]] Plot3d read_plot3d(const std::filesystem::path& file);

} // namespace io
