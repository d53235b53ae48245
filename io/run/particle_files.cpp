// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Files that the particles of a scene come from.
#include "core/base/error.hpp"
#include "io/run/grain_file.hpp"
#include "io/scene/scene_reader.hpp"
#include <fmt/format.h>

namespace io {
namespace {

/// @throws core::ConfigError for a mistake in a table, or a checkpoint that is not there.
void try_file(const Scene& scene, const std::string& file)
{
    if (is_checkpoint(file)) return core::require<core::ConfigError>(std::filesystem::exists(file), fmt::format("there is no {}", file));
    std::vector<std::string> names;
    for (const Species& species : scene.particles) names.push_back(species.name);
    (void)grains_of_table(file, names);
}

} // namespace

void read_particle_files(Scene& scene, const std::filesystem::path& folder, Locations& locations, Problems& problems)
{
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
        std::string& file = scene.particles[n].file;
        const std::string path = fmt::format("particles.{}.file", n);
        if (file.empty() || !locations.good(path)) continue;
        file = std::filesystem::absolute(folder / file).lexically_normal().string();
        try {
            try_file(scene, file);
        } catch (const core::ConfigError& error) {
            problems.add(locations.at(path), error.what(), "");
            locations.spoil(path);
        }
    }
}

} // namespace io
