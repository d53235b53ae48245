// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/plot3d.hpp"
#include "io/files/plot3d_parts.hpp"
#include "io/scene/scene_reader.hpp"
#include <algorithm>

namespace io {

Plot3d read_plot3d(const std::filesystem::path& file)
{
    const std::string content = text_of(file), name = file.string();
    core::require<core::ConfigError>(!content.empty(), name + " is empty");
    const bool is_text = std::all_of(content.begin(), content.begin() + std::ptrdiff_t(std::min<std::size_t>(content.size(), 1024)),
                                     [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t'; });
    Plot3d grid;
    grid.form = "text";
    const auto blocks = is_text ? read_plot3d_text(content, name) : read_plot3d_binary(content, name, grid.form);
    for (std::size_t b = 0; b < blocks.size(); ++b) grid.blocks.push_back(vertices_of(blocks[b], b, name));
    return grid;
}

} // namespace io
