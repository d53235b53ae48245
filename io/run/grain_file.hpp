// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Grains from files: a table of places and sizes, or a checkpoint of another run.
#include "core/comm/communicator.hpp"
#include "core/particles/particle_set.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace io {

/// Is the path that of a checkpoint, or of a folder of them?
[[nodiscard]] bool is_checkpoint(const std::filesystem::path& path);

/// One grain for each line: x, y, z, diameter [m], density [kg/m3], species (a name, or its number from 0), and, if there are nine columns,
/// the velocity [m/s]; separated and commented as in table_file.hpp. Ids are not set.
/// @param names  Of the species.
/// @returns positions as the file has them. @throws core::ConfigError with file, line and column.
[[nodiscard]] std::vector<core::Sphere> grains_of_table(const std::filesystem::path& file, const std::vector<std::string>& names);

/// All grains of a checkpoint, or of the newest good one in a folder, in the order of their ids; without their springs. Collective.
/// @returns positions relative to the low corner of the other run's domain.
[[nodiscard]] std::vector<core::Sphere> grains_of_checkpoint(const std::filesystem::path& path, const core::Communicator& ranks);

} // namespace io
