// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parts of a Plot3D file, as text or binary readers find them.
#include "core/base/error.hpp"
#include "io/files/plot3d.hpp"
#include <string>

namespace io {

/// All coordinates of a block: x of all points, then y, then z, then the blanking if there is one.
struct Plot3dBlock {
    core::Extents points;
    std::vector<double> numbers;
};

/// @throws core::ConfigError naming `file`.
[[nodiscard]] core::Vertices vertices_of(const Plot3dBlock& block, std::size_t number, const std::string& file);

/// Blocks of a text of numbers separated by blanks or commas; `3*0.5` stands for three times 0.5.
[[nodiscard]] std::vector<Plot3dBlock> read_plot3d_text(const std::string& text, const std::string& file);

/// Blocks of a binary file.
/// @param[out] form  How it was written, in words.
[[nodiscard]] std::vector<Plot3dBlock> read_plot3d_binary(const std::string& bytes, const std::string& file, std::string& form);

} // namespace io
