// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// An image in memory and its way into a PNG file.
#include <cstdint>
#include <string>
#include <vector>

namespace io {

/// Rows from the top, three bytes (red, green, blue) for each pixel.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// By way of a temporary file. @throws core::FileError
void write_png(const Image& image, const std::string& path);

} // namespace io
