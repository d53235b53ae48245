// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/line_plot.hpp"
#include "io/study/svg.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace io {
namespace {

using svg::line, svg::text;

constexpr double width = 560, height = 300, left = 84, right = 20, top = 44, bottom = 52;
constexpr std::size_t most_points = 1500; // more than the columns of pixels of the picture

struct Range {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// Never empty, with some room at both ends.
    void widen(double share)
    {
        if (low > high) low = high = 0;
        const double size = high - low, least = 1e-9 * std::max(std::abs(low), std::abs(high));
        const double margin = size > least ? share * size : std::max(0.05 * std::abs(high), 1e-300);
        low -= margin;
        high += margin;
    }
    [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

struct Frame {
    Range x, y;
    [[nodiscard]] double px(double value) const { return left + x.share(value) * (width - left - right); }
    [[nodiscard]] double py(double value) const { return height - bottom - y.share(value) * (height - top - bottom); }
};

/// About five round numbers within a range.
std::vector<double> ticks(const Range& range)
{
    const double rough = (range.high - range.low) / 5, power = std::pow(10, std::floor(std::log10(rough)));
    const double digit = rough / power, step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
    std::vector<double> values;
    for (double n = std::ceil(range.low / step); n * step <= range.high && values.size() < 20; ++n)
        values.push_back(n * step + 0.0); // no minus before a zero
    return values;
}

std::string axes(const LinePlot& plot, const Frame& frame)
{
    const std::string grid = "stroke=\"#e3e6ea\"", axis = "stroke=\"#333\"";
    std::string out;
    for (const double t : ticks(frame.x)) {
        out += line(frame.px(t), top, frame.px(t), height - bottom, grid);
        out += text(frame.px(t), height - bottom + 18, "middle", fmt::format("{:.5g}", t));
    }
    for (const double t : ticks(frame.y)) {
        out += line(left, frame.py(t), width - right, frame.py(t), grid);
        out += text(left - 8, frame.py(t) + 4, "end", fmt::format("{:.5g}", t));
    }
    out += line(left, height - bottom, width - right, height - bottom, axis) + line(left, top, left, height - bottom, axis);
    out += text((left + width - right) / 2, height - 14, "middle", plot.x_label);
    out += text(0, 0, "middle", plot.y_label, fmt::format("transform=\"translate(16 {:.1f}) rotate(-90)\"", (top + height - bottom) / 2));
    return out + text(left, 24, "start", plot.title, "font-size=\"15\" font-weight=\"600\"");
}

/// Numbers of the points to draw: all, or the lowest and the highest of each stretch.
std::vector<std::size_t> thinned(const std::vector<double>& y, std::size_t count)
{
    const std::size_t stretch = std::max<std::size_t>(1, 2 * count / most_points);
    std::vector<std::size_t> kept;
    for (std::size_t first = 0; first < count; first += stretch) {
        const auto begin = y.begin() + std::ptrdiff_t(first), end = y.begin() + std::ptrdiff_t(std::min(first + stretch, count));
        const auto [low, high] = std::minmax_element(begin, end);
        kept.push_back(std::size_t(std::min(low, high) - y.begin()));
        if (low != high) kept.push_back(std::size_t(std::max(low, high) - y.begin()));
    }
    return kept;
}

std::string drawn(const Curve& curve, const Frame& frame, std::size_t number)
{
    const char* colour = svg::colours[number % svg::colours.size()];
    std::string path;
    for (const std::size_t n : thinned(curve.y, std::min(curve.x.size(), curve.y.size()))) {
        if (!std::isfinite(curve.x[n]) || !std::isfinite(curve.y[n])) continue;
        path += fmt::format("{}{:.1f} {:.1f} ", path.empty() ? "M" : "L", frame.px(curve.x[n]), frame.py(curve.y[n]));
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" stroke-linejoin=\"round\"/>\n", path, colour);
}

/// Names beside the title, from the right.
std::string names(const LinePlot& plot)
{
    std::string out;
    double x = width - right;
    for (std::size_t n = plot.curves.size(); n-- > 0 && plot.curves.size() > 1;) {
        out += text(x, 24, "end", plot.curves[n].name, fmt::format("style=\"fill:{}\"", svg::colours[n % svg::colours.size()]));
        x -= 7.0 * double(plot.curves[n].name.size()) + 14;
    }
    return out;
}

} // namespace

std::string to_svg(const LinePlot& plot)
{
    Frame frame;
    for (const Curve& curve : plot.curves)
        for (std::size_t n = 0; n < std::min(curve.x.size(), curve.y.size()); ++n)
            if (std::isfinite(curve.x[n]) && std::isfinite(curve.y[n])) {
                frame.x.add(curve.x[n]);
                frame.y.add(curve.y[n]);
            }
    frame.x.widen(0.0);
    frame.y.widen(0.06);
    std::string out = svg::opening(width, height) + axes(plot, frame);
    for (std::size_t n = 0; n < plot.curves.size(); ++n) out += drawn(plot.curves[n], frame, n);
    return out + names(plot) + "</svg>\n";
}

} // namespace io
