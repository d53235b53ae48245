// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files that hold a scene, or name one, beside keys of their own: studies and stress cases.
#include "core/base/error.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/yaml.hpp"

namespace io {

/// A scene that can be read several times, each time with other overrides.
struct SceneSource {
    Node node;                       ///< a path, or the scene itself
    std::filesystem::path folder;    ///< that paths are relative to
    std::shared_ptr<Problems> texts; ///< keeps alive what the marks of the node point to

    /// @throws core::ConfigError with all problems, each with its place.
    [[nodiscard]] Scene read(const std::vector<std::string>& overrides) const;
};

/// The key of a scene: the path of a scene.yaml or of its folder, or the keys of a scene.
[[nodiscard]] Value scene_value(SceneSource& place);

/// A list of values of one kind.
template <class T>
[[nodiscard]] Value list_value(std::vector<T>& place, std::string_view unit, Range range = {})
{
    T inside{};
    Value value = value_of(inside, unit, range);
    value.length = -1;
    value.read = [&place, u = std::string(unit), range](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::list || node.items.empty())
            return reading.problems.add(node.mark, "this must be a list, and is " + name_of(node.kind), "write [...]");
        place.assign(node.items.size(), T{});
        for (std::size_t n = 0; n < place.size(); ++n) value_of(place[n], u, range).read(node.items[n], reading);
    };
    value.write = [&place, u = std::string(unit), range] {
        std::string all;
        for (T& item : place) all += (all.empty() ? "" : ", ") + value_of(item, u, range).write();
        return "[" + all + "]";
    };
    return value;
}

/// Reads a file that describes one struct with a member `scene` of type SceneSource.
/// @throws core::ConfigError with all problems, each with its place.
template <class T>
[[nodiscard]] T read_described(const std::filesystem::path& file)
{
    T result{};
    result.scene.folder = file.parent_path();
    result.scene.texts = std::make_shared<Problems>();
    Problems& problems = *result.scene.texts;
    const Source& source = problems.add_source(file.string(), text_of(file));
    if (const std::optional<Node> root = parse_yaml(source, problems)) {
        const Units units;
        const Reading reading{units, problems};
        Locations locations;
        SchemaReader reader(*root, "", {&source, 1, 1}, reading, locations);
        describe(reader, result);
        reader.finish();
    }
    core::require<core::ConfigError>(problems.empty(), problems.text());
    return result;
}

} // namespace io
