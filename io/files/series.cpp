// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/series.hpp"
#include "io/files/durable.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace io {

Series::Series(std::string path) : path_(std::move(path))
{
    std::ifstream file(path_);
    const auto list = nlohmann::json::parse(file, nullptr, false);
    if (!list.is_object() || !list.contains("files") || !list["files"].is_array()) return;
    for (const auto& entry : list["files"])
        if (entry.is_object() && entry.contains("name") && entry.contains("time"))
            entries_.push_back({entry["name"].get<std::string>(), entry["time"].get<double>()});
}

void Series::add(const std::string& file, double time)
{
    std::erase_if(entries_, [&](const Entry& entry) { return entry.time >= time || entry.file == file; });
    entries_.push_back({file, time});
    nlohmann::json files = nlohmann::json::array();
    for (const Entry& entry : entries_) files.push_back({{"name", entry.file}, {"time", entry.time}});
    write_durably(path_, nlohmann::json{{"file-series-version", "1.0"}, {"files", files}}.dump(1) + "\n");
}

} // namespace io
