// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Colours of pictures: a map from numbers to colours of evenly rising lightness, and a few that are easy to tell apart.
#include <array>

namespace io {

/// sRGB, each part in [0, 1].
using Colour = std::array<float, 3>;

/// From OKLab (lightness in [0, 1], green-red, blue-yellow), parts cut to [0, 1].
/// @source  B. Ottosson, A perceptual color space for image processing (2020).
[[nodiscard]] Colour from_oklab(double lightness, double a, double b);

/// Deep blue (0) over green to pale yellow (1); lightness rises linearly, so it also reads in grey.
[[nodiscard]] Colour sequential_colour(double fraction);

/// Colour of species number `index`, well apart for colour-blind eyes too; repeats after eight.
[[nodiscard]] Colour species_colour(int index);

} // namespace io
