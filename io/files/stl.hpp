// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles from an STL file, in text or binary.
#include "core/base/vec3.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace io {

/// Corners of the triangles in the order of the file and in its units; nothing is joined yet. The normals of the file are not read:
/// they follow from the order of the corners.
/// @throws core::ConfigError for a file that cannot be read, with the line of a text or the byte of a binary file.
[[nodiscard]] std::vector<std::array<core::Vec3, 3>> read_stl(const std::filesystem::path& file);

/// Writes a binary STL file. @throws core::FileError if it cannot be written.
void write_stl(const std::filesystem::path& file, const std::vector<std::array<core::Vec3, 3>>& triangles);

} // namespace io
