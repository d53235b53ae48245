// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fills described structs from a YAML tree and gathers everything that does not fit.
#include "io/scene/schema.hpp"
#include <map>
#include <set>

namespace io {

/// Where each key of a scene stands, by path ("grid.pipe.diameter", "particles.0.count"), and which of them went wrong.
class Locations {
public:
    void place(const std::string& path, Mark mark) { marks_[path] = mark; }
    void spoil(const std::string& path) { spoiled_.insert(path); }

    /// The mark of the path, or of the nearest key above it that was given.
    [[nodiscard]] Mark at(std::string path) const;
    /// False when the value at the path, or one above or below it, could not be read.
    [[nodiscard]] bool good(const std::string& path) const;
    [[nodiscard]] bool given(const std::string& path) const { return marks_.contains(path); }

private:
    std::map<std::string, Mark> marks_;
    std::set<std::string> spoiled_;
};

/// Reads one map of a YAML tree. finish() must be called after the description has spoken.
class SchemaReader final : public Schema {
public:
    /// @param path  Of this map, ending in a dot; empty for the whole scene.
    /// @param here  Where missing keys are reported: the key of this map.
    SchemaReader(const Node& map, std::string path, Mark here, const Reading& reading, Locations& locations);

    void exactly_one(const std::vector<std::string>& keys) override;
    /// Reports missing keys and keys that nothing describes.
    void finish();

private:
    void on_value(const Leaf& leaf) override;
    void on_group(const Group& group) override;
    void on_list(const List& list) override;

    [[nodiscard]] const Member* take(const std::string& key);
    [[nodiscard]] const Member* take_named(const Group& group);
    [[nodiscard]] std::vector<const Member*> unused() const;
    void read_group(const Node& node, const std::string& path, Mark key, const std::function<void(Schema&)>& inside);
    void miss(const std::string& key, const std::string& meaning);

    const Node& map_;
    std::string path_;
    Mark here_;
    const Reading& reading_;
    Locations& locations_;
    std::vector<std::string> known_;
    std::set<std::string> used_;
    std::vector<std::pair<std::string, std::string>> missing_; // key, meaning
};

} // namespace io
