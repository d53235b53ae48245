// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_reader.hpp"

#include "core/base/error.hpp"
#include "io/scene/scene_description.hpp"
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace io {

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    core::require<core::ConfigError>(stream.good(), fmt::format("{} cannot be read", file.string()));
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path scene_file(const std::filesystem::path& path)
{
    namespace fs = std::filesystem;
    const fs::path file = fs::is_directory(path) ? path / "scene.yaml" : path;
    core::require<core::ConfigError>(fs::is_regular_file(file),
                                     fmt::format("there is no scene at {}; give a scene.yaml or its folder", path.string()));
    return file;
}

Scene read_scene_tree(Node& root, Mark start, const std::vector<std::string>& overrides, Problems& problems)
{
    for (const auto& assignment : overrides) apply_override(root, assignment, problems);
    const Units units;
    const Reading reading{units, problems};
    Locations locations;
    locations.place("", start);
    SchemaReader reader(root, "", start, reading, locations);
    Scene scene;
    describe(reader, scene);
    reader.finish();
    const auto folder = std::filesystem::path(start.source->name).parent_path();
    check_grid(scene.grid, folder, locations, problems);
    if (scene.fluid) read_fluid_files(*scene.fluid, folder, locations, problems);
    read_particle_files(scene, folder, locations, problems);
    read_wall_files(scene.walls, folder, locations, problems);
    check_scene(scene, locations, problems);
    if (problems.empty()) scene.resolve();
    return scene;
}

SceneReading read_scene_text(const std::string& name, const std::string& text, const std::vector<std::string>& overrides)
{
    SceneReading result{{}, std::make_unique<Problems>()};
    Problems& problems = *result.problems;
    const Source& source = problems.add_source(name, text);
    // Without a tree, what else is wrong cannot be known.
    if (std::optional<Node> root = parse_yaml(source, problems))
        result.scene = read_scene_tree(*root, {&source, 1, 1}, overrides, problems);
    return result;
}

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
    const auto file = scene_file(path);
    SceneReading reading = read_scene_text(file.string(), text_of(file), overrides);
    core::require<core::ConfigError>(reading.problems->empty(), reading.problems->text());
    return std::move(reading.scene);
}

} // namespace io
