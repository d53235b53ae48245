// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_text.hpp"
#include "io/picture/picture_font.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace io {
namespace {

struct Point {
    double x = 0.0, y = 0.0;
};
using Stroke = std::vector<Point>;

/// Smooth curve through the points, as short lines: cubic Hermite pieces whose tangents turn four points of a circle into
/// that circle.
Stroke smooth(const Stroke& points, std::ptrdiff_t closed)
{
    const auto n = std::ptrdiff_t(points.size());
    const auto at = [&](std::ptrdiff_t k) { return points[std::size_t(closed ? (k + n) % n : std::clamp<std::ptrdiff_t>(k, 0, n - 1))]; };
    Stroke curve;
    constexpr int steps = 8;
    for (std::ptrdiff_t k = 0; k + 1 < n + closed; ++k)
        for (int s = 0; s <= steps; ++s) {
            constexpr double c = 0.828; // 2 (sqrt(2) - 1)
            const double t = double(s) / steps, out = t * (1 - t) * (1 - t) * c, in = t * t * (1 - t) * c, step = t * t * (3 - 2 * t);
            const double w[4] = {-out, 1 - step + in, step + out, -in};
            Point sum;
            for (std::ptrdiff_t m = 0; m < 4; ++m) {
                sum.x += w[m] * at(k + m - 1).x;
                sum.y += w[m] * at(k + m - 1).y;
            }
            curve.push_back(sum);
        }
    return curve;
}

std::vector<Stroke> strokes_of(char letter)
{
    std::vector<Stroke> strokes;
    std::istringstream words{std::string(detail::strokes_of(letter))};
    for (std::string word; words >> word;) {
        const char kind = word.front();
        if (kind == '~' || kind == '@') word.erase(0, 1);
        Stroke points;
        for (std::size_t n = 0; n + 1 < word.size(); n += 2) points.push_back({double(word[n] - '0'), double(word[n + 1] - '0')});
        strokes.push_back(kind == '~' ? smooth(points, 0) : kind == '@' ? smooth(points, 1) : points);
    }
    return strokes;
}

/// Left end and advance of a letter, in units of its grid.
std::pair<double, double> span_of(char letter)
{
    if (letter == ' ') return {0.0, 3.2};
    double low = 4.0, high = 0.0;
    for (const Stroke& stroke : strokes_of(letter))
        for (const Point p : stroke) {
            low = std::min(low, p.x);
            high = std::max(high, p.x);
        }
    return {low, high - low + 1.9};
}

void blend(Image& image, int x, int y, const Colour& colour, double cover)
{
    if (x < 0 || y < 0 || x >= image.width || y >= image.height || cover <= 0.0) return;
    std::uint8_t* pixel = &image.rgb[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
    for (int c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t(std::lround(pixel[c] + std::min(cover, 1.0) * (255.0 * double(colour[std::size_t(c)]) - pixel[c])));
}

double distance(Point p, Point a, Point b)
{
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double t = length2 > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// A line of round ends and half width `radius`, edges smooth over one pixel.
void draw_stroke(Image& image, const Stroke& stroke, double radius, const Colour& colour)
{
    Point low = stroke.front(), high = low;
    for (const Point p : stroke) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    for (int y = int(low.y - radius - 1); y <= int(high.y + radius + 1); ++y)
        for (int x = int(low.x - radius - 1); x <= int(high.x + radius + 1); ++x) {
            const Point centre{x + 0.5, y + 0.5};
            double nearest = std::hypot(centre.x - stroke[0].x, centre.y - stroke[0].y);
            for (std::size_t n = 1; n < stroke.size(); ++n) nearest = std::min(nearest, distance(centre, stroke[n - 1], stroke[n]));
            blend(image, x, y, colour, radius + 0.5 - nearest);
        }
}

void draw_bar(Image& image, const ColourBar& bar, double unit)
{
    const double width = 15 * unit, height = 0.7 * unit, left = image.width - width - 2 * unit, top = image.height - 3.2 * unit;
    for (int y = int(top); y < int(top + height); ++y)
        for (int x = int(left); x < int(left + width); ++x) blend(image, x, y, sequential_colour((x - left) / width), 1.0);
    const std::string low = fmt::format("{:.3g}", bar.low), high = fmt::format("{:.3g}", bar.high);
    const double base = top + 2.1 * unit, size = 0.75 * unit;
    draw_text(image, low, {left, base, size});
    draw_text(image, high, {left + width - text_width(high, size), base, size});
    draw_text(image, bar.title, {left, top - 0.6 * unit, size});
}

} // namespace

double text_width(const std::string& text, double height)
{
    double units = 0.0;
    for (const char letter : text) units += span_of(letter).second;
    return units * height / 6.0;
}

void draw_text(Image& image, const std::string& text, const Pen& pen)
{
    const double scale = pen.height / 6.0;
    double x = pen.x;
    for (const char letter : text) {
        const auto [left, advance] = span_of(letter);
        for (Stroke stroke : strokes_of(letter)) {
            for (Point& p : stroke) p = {x + (p.x - left) * scale, pen.y - (p.y - 2.0) * scale};
            draw_stroke(image, stroke, 0.5 * pen.weight * pen.height, pen.colour);
        }
        x += advance * scale;
    }
}

void draw_caption(Image& image, const Caption& caption)
{
    const double unit = std::max(12.0, image.height / 48.0);
    const Colour quiet{0.38f, 0.42f, 0.48f};
    draw_text(image, caption.title, {2 * unit, 3 * unit, unit, Pen{}.colour, 0.13});
    draw_text(image, caption.detail, {2 * unit, 5 * unit, 0.8 * unit, quiet});
    double y = image.height - 2 * unit - 1.7 * unit * (double(caption.legend.size()) - 1.0);
    for (const LegendEntry& entry : caption.legend) {
        draw_stroke(image, {{2.5 * unit, y - 0.4 * unit}}, 0.5 * unit, entry.colour);
        draw_text(image, entry.text, {3.8 * unit, y, 0.8 * unit, quiet});
        y += 1.7 * unit;
    }
    if (caption.bar) draw_bar(image, *caption.bar, unit);
}

} // namespace io
