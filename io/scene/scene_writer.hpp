// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What comes of the descriptions besides reading: the resolved scene, the JSON Schema, and the text of `isago explain`.
#include "io/scene/scene.hpp"
#include <string>
#include <vector>

namespace io {

/// The scene as YAML with every key in it, in SI units. Reading it gives the same scene, bit for bit.
[[nodiscard]] std::string scene_text(const Scene& scene);

/// A JSON Schema (draft-07) of scene.yaml, for editors.
[[nodiscard]] std::string json_schema();

/// One key of a scene.
struct KeyEntry {
    std::string path; ///< "grid.pipe.diameter"; items of a list are "particles.*.count".
    std::string meaning;
    std::string form; ///< What to write; empty for a group.
    std::string need; ///< "required", "optional" or the default.
    [[nodiscard]] bool is_group() const { return form.empty(); }
};

/// All keys, in the order of the descriptions, each group before its keys.
[[nodiscard]] std::vector<KeyEntry> all_keys();

/// Explains a key by its whole path, its end ("pipe.diameter", "diameter"), or all keys for an empty word.
/// @throws core::ConfigError with a suggestion for a key that does not exist.
[[nodiscard]] std::string explain(const std::string& key);

} // namespace io
