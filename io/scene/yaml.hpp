// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A YAML text as a tree that remembers where every key and value stands.
#include "io/scene/problems.hpp"
#include <optional>
#include <string>
#include <vector>

namespace io {

struct Member;

/// A value: nothing, a word or number, a list, or a map.
struct Node {
    enum class Kind { null, scalar, list, map };
    Kind kind = Kind::null;
    Mark mark;
    std::string text;            ///< Of a scalar.
    bool quoted = false;         ///< A quoted scalar is text, even if it looks like a number.
    std::vector<Node> items;     ///< Of a list.
    std::vector<Member> members; ///< Of a map, in the order of the text.

    /// The value of a key, or nullptr.
    [[nodiscard]] Node* find(const std::string& key);
};

struct Member {
    std::string key;
    Mark mark; ///< Of the key.
    Node value;
    bool merged = false; ///< Came through a merge key: a key of the map itself may replace it.
};

/// "a word", "a list", ... for messages.
[[nodiscard]] std::string name_of(Node::Kind kind);

/// Reads one document; nothing if its syntax is broken. Broken syntax, keys given twice, unknown or recursive aliases and further
/// documents are added to `problems`. Anchors, aliases and merge keys (`<<`) are expanded; a key of the map itself wins over a merged one.
/// @param from  The text before this position counts as blanks.
[[nodiscard]] std::optional<Node> parse_yaml(const Source& source, Problems& problems, std::size_t from = 0);

/// Applies one override "key.path=value" to a tree. Steps of the path are keys, positions in a list (from 0), or the
/// `name` of an item of a list; maps that are missing are made.
void apply_override(Node& root, const std::string& assignment, Problems& problems);

} // namespace io
