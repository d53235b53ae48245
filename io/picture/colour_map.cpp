// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

double gamma(double linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055; }

Colour from_hue(double lightness, double chroma, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return from_oklab(lightness, chroma * std::cos(angle), chroma * std::sin(angle));
}

} // namespace

Colour from_oklab(double lightness, double a, double b)
{
    const double long_root = lightness + 0.3963377774 * a + 0.2158037573 * b;
    const double medium_root = lightness - 0.1055613458 * a - 0.0638541728 * b;
    const double short_root = lightness - 0.0894841775 * a - 1.2914855480 * b;
    const double l = std::pow(long_root, 3), m = std::pow(medium_root, 3), s = std::pow(short_root, 3);
    const double rgb[3] = {+4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                           -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) colour[c] = float(gamma(std::clamp(rgb[c], 0.0, 1.0)));
    return colour;
}

Colour sequential_colour(double fraction)
{
    const double t = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
    const double chroma = 0.115 - 0.04 * std::sin(std::numbers::pi * t) + 0.045 * t; // stays inside sRGB
    return from_hue(0.30 + 0.62 * t, chroma, 285.0 - 180.0 * t);
}

Colour species_colour(int index)
{
    constexpr double hues[8] = {250.0, 55.0, 165.0, 350.0, 105.0, 300.0, 205.0, 25.0};
    constexpr double lightness[8] = {0.58, 0.74, 0.66, 0.62, 0.84, 0.48, 0.78, 0.52};
    const auto n = std::size_t(((index % 8) + 8) % 8);
    return from_hue(lightness[n], 0.125, hues[n]);
}

} // namespace io
