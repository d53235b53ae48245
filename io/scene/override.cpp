// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/yaml.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace io {

namespace {

struct Step {
    std::string name;
    Mark mark;
};

/// The words between the dots of "a.b.0".
[[nodiscard]] std::vector<Step> steps_of(const std::string& path, const Source& source)
{
    std::vector<Step> steps;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        steps.push_back({path.substr(begin, end - begin), {&source, 1, static_cast<int>(begin) + 1}});
        begin = end + 1;
    }
    return steps;
}

/// The item at a position, or the item whose name is the step.
[[nodiscard]] Node* item_of(Node& list, const std::string& step)
{
    std::size_t position = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), position);
    if (error == std::errc() && end == step.data() + step.size()) return position < list.items.size() ? &list.items[position] : nullptr;
    for (Node& item : list.items)
        if (const Node* name = item.find("name"); name != nullptr && name->text == step) return &item;
    return nullptr;
}

[[nodiscard]] Node& member_of(Node& map, const Step& step)
{
    if (Node* found = map.find(step.name)) return *found;
    map.kind = Node::Kind::map;
    map.members.push_back({step.name, step.mark, {}});
    map.members.back().value.mark = step.mark;
    return map.members.back().value;
}

} // namespace

void apply_override(Node& root, const std::string& assignment, Problems& problems)
{
    const Source& source = problems.add_source("--set", assignment);
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) return problems.add({&source, 1, 1}, "an override is written key.path=value");

    Node* place = &root;
    for (const Step& step : steps_of(assignment.substr(0, equals), source)) {
        if (place->kind == Node::Kind::scalar) return problems.add(step.mark, fmt::format("'{}' stands below a single value", step.name));
        place = place->kind == Node::Kind::list ? item_of(*place, step.name) : &member_of(*place, step);
        if (place == nullptr)
            return problems.add(step.mark, fmt::format("the list has no item '{}'", step.name),
                                "give its position, counted from 0, or its name");
    }
    *place = parse_yaml(source, problems, equals + 1).value_or(Node{});
    if (place->kind == Node::Kind::null) place->mark = {&source, 1, static_cast<int>(equals) + 2};
}

} // namespace io
