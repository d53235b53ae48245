// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_source.hpp"
#include "core/base/error.hpp"

namespace io {

Scene SceneSource::read(const std::vector<std::string>& overrides) const
{
    if (node.kind == Node::Kind::scalar) return read_scene(folder / node.text, overrides);
    Problems problems;
    Node root = node;
    Scene scene = read_scene_tree(root, node.mark, overrides, problems);
    core::require<core::ConfigError>(problems.empty(), problems.text());
    return scene;
}

Value scene_value(SceneSource& place)
{
    std::string text;
    Value value = value_of(text, "", any_number);
    value.read = [&place](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::scalar && node.kind != Node::Kind::map)
            return reading.problems.add(node.mark, "this must be the path of a scene or the scene itself, and is " + name_of(node.kind));
        place.node = node;
    };
    value.write = [&place] { return place.node.text; };
    return value;
}

} // namespace io
