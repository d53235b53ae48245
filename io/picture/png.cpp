// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/png.hpp"
#include "core/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <png.h>

namespace io {

void write_png(const Image& image, const std::string& path)
{
    png_image description{};
    description.version = PNG_IMAGE_VERSION;
    description.width = png_uint_32(image.width);
    description.height = png_uint_32(image.height);
    description.format = PNG_FORMAT_RGB;
    const std::string temporary = path + ".part";
    const bool written = png_image_write_to_file(&description, temporary.c_str(), 0, image.rgb.data(), 3 * image.width, nullptr) != 0;
    if (!written) std::remove(temporary.c_str());
    core::require<core::FileError>(written, core::text(path, ": cannot write the picture: ", description.message));
    core::require<core::FileError>(std::rename(temporary.c_str(), path.c_str()) == 0,
                                   core::text(path, ": cannot write the picture: ", std::strerror(errno)));
}

} // namespace io
