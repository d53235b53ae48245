// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_writer.hpp"

#include "core/base/error.hpp"
#include "io/scene/scene_description.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace io {

namespace {

class KeyCollector final : public Schema {
public:
    KeyCollector(std::vector<KeyEntry>& keys, std::string path) : keys_(keys), path_(std::move(path)) {}

    void exactly_one(const std::vector<std::string>&) override {}

private:
    void on_value(const Leaf& leaf) override
    {
        const std::string written = leaf.need == Need::required ? "" : leaf.value.write();
        const std::string need = leaf.need == Need::required ? "required" : written.empty() ? "optional" : "default " + written;
        keys_.push_back({path_ + leaf.key, leaf.meaning, form_of(leaf.value), need});
    }

    void on_group(const Group& group) override
    {
        const std::string need = group.need == Need::required ? "required" : "optional";
        add_group(group.key, group.meaning, need, group.key + ".", group.example);
    }

    void on_list(const List& list) override { add_group(list.key, list.meaning, "optional, a list", list.key + ".*.", list.example); }

    void add_group(const std::string& key, const std::string& meaning, const std::string& need, const std::string& inner_path,
                   const std::function<void(Schema&)>& example)
    {
        keys_.push_back({path_ + key, meaning, "", need});
        KeyCollector inner(keys_, path_ + inner_path);
        example(inner);
    }

    std::vector<KeyEntry>& keys_;
    std::string path_;
};

[[nodiscard]] std::string text_of(const KeyEntry& key)
{
    std::string text = fmt::format("{}\n    {}\n", key.path, key.meaning);
    if (!key.is_group()) text += fmt::format("    write:  {}\n", key.form);
    return text + fmt::format("    given:  {}\n", key.need);
}

[[nodiscard]] std::string last_step(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// The whole path (with or without the stars of lists), or its end.
[[nodiscard]] bool means(const std::string& word, std::string path)
{
    if (const auto star = path.find(".*"); star != std::string::npos && word.find('*') == std::string::npos) path.erase(star, 2);
    return path == word || path.ends_with("." + word);
}

} // namespace

std::vector<KeyEntry> all_keys()
{
    std::vector<KeyEntry> keys;
    KeyCollector collector(keys, "");
    Scene scene;
    describe(collector, scene);
    return keys;
}

std::string explain(const std::string& key)
{
    const auto keys = all_keys();
    std::string whole, text; // the path that was asked for goes first
    std::vector<std::string> names;
    for (const auto& entry : keys) {
        names.push_back(last_step(entry.path));
        names.push_back(entry.path);
        if (!key.empty() && !means(key, entry.path)) continue;
        std::string& to = entry.path == key ? whole : text;
        to += text_of(entry);
        if (key.empty() || !entry.is_group()) continue;
        for (const auto& inner : keys)
            if (inner.path.starts_with(entry.path + ".")) to += text_of(inner);
    }
    if (!whole.empty() || !text.empty()) return whole + text;
    const std::string near = nearest(key, names);
    throw core::ConfigError(fmt::format("there is no key '{}'; {}", key,
                                        near.empty() ? "`isago explain` shows all keys" : fmt::format("did you mean '{}'?", near)));
}

} // namespace io
