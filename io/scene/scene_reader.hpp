// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a scene.yaml to a Scene, or to the list of everything that is wrong with it.
#include "io/scene/problems.hpp"
#include "io/scene/scene.hpp"
#include "io/scene/schema_reader.hpp"
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace io {

/// The scene file that a user means: the file itself, or scene.yaml in a folder.
/// @throws core::ConfigError if there is none.
[[nodiscard]] std::filesystem::path scene_file(const std::filesystem::path& path);

/// A scene that was read; usable only when `problems` is empty.
struct SceneReading {
    Scene scene;
    std::unique_ptr<Problems> problems; // by pointer: marks point into it
};

/// Reads a scene from a text. `overrides` are "key.path=value" and are applied in order.
/// @param name  Stands for the text in messages.
[[nodiscard]] SceneReading read_scene_text(const std::string& name, const std::string& text,
                                           const std::vector<std::string>& overrides = {});

/// Reads a scene file or the scene.yaml of a folder.
/// @throws core::ConfigError with all problems, each with its place, if there are any.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// Reads a scene from a tree, which the overrides change; what is wrong is added to `problems`.
/// @param start  Where keys are reported that are missing at the top.
[[nodiscard]] Scene read_scene_tree(Node& root, Mark start, const std::vector<std::string>& overrides, Problems& problems);

/// The text of a file. @throws core::ConfigError if it cannot be read.
[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// Checks the grid, and makes it once to know what it fills.
/// @param folder  That files are relative to.
void check_grid(Grid& grid, const std::filesystem::path& folder, Locations& locations, Problems& problems);

/// Reads the tables in files that a fluid refers to, and makes other paths absolute.
void read_fluid_files(Fluid& fluid, const std::filesystem::path& folder, Locations& locations, Problems& problems);

/// Makes the files of species absolute paths, and reads tables once, for their mistakes.
void read_particle_files(Scene& scene, const std::filesystem::path& folder, Locations& locations, Problems& problems);
/// Makes the paths of walls' files absolute, and reads the files once.
void read_wall_files(std::vector<WallKeys>& walls, const std::filesystem::path& folder, Locations& locations, Problems& problems);

/// Finds mistakes that only several keys together show; says nothing about values that could not be read.
void check_boundaries(const Scene& scene, const Locations& locations, Problems& problems);
void check_contact_sides(const Scene& scene, const Locations& locations, Problems& problems);
void check_turn(const Scene& scene, const Locations& locations, Problems& problems);
void check_particles(const Scene& scene, const Locations& locations, Problems& problems);
void check_walls(const Scene& scene, const Locations& locations, Problems& problems);
void check_scene(const Scene& scene, const Locations& locations, Problems& problems);

} // namespace io
