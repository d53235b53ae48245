// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text and legend drawn into an image: a small stroke font of our own, smooth at any size.
#include "io/picture/picture.hpp"
#include "io/picture/png.hpp"

namespace io {

struct Pen {
    double x = 0.0, y = 0.0; ///< left end of the base line [pixels from the upper left corner]
    double height = 16.0;    ///< of a capital letter [pixels]
    Colour colour{0.16f, 0.19f, 0.24f};
    double weight = 0.11; ///< width of the strokes over the height
};

[[nodiscard]] double text_width(const std::string& text, double height);
void draw_text(Image& image, const std::string& text, const Pen& pen);
void draw_caption(Image& image, const Caption& caption);

} // namespace io
