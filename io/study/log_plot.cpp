// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/log_plot.hpp"
#include "io/study/svg.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace io {
namespace {

using svg::colours, svg::line, svg::text;

constexpr double width = 720, height = 480, left = 86, right = 170, top = 46, bottom = 62;

struct Range {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest(); ///< decimal logarithms
    void add(double value)
    {
        low = std::min(low, std::log10(value));
        high = std::max(high, std::log10(value));
    }
    /// Room on both sides, and at least half a decade.
    void widen()
    {
        if (low > high) low = high = 0;
        const double margin = std::max(0.08 * (high - low), 0.25 - (high - low) / 2);
        low -= margin;
        high += margin;
    }
};

struct Frame {
    Range x, y;
    [[nodiscard]] double px(double log_x) const { return left + (log_x - x.low) / (x.high - x.low) * (width - left - right); }
    [[nodiscard]] double py(double log_y) const { return height - bottom - (log_y - y.low) / (y.high - y.low) * (height - top - bottom); }
};

/// Values 1, 2, 5 times powers of ten within a range; only powers of ten where there are many.
std::vector<double> ticks(const Range& range)
{
    const bool few = range.high - range.low < 1.6;
    std::vector<double> values;
    for (int decade = int(std::floor(range.low)); decade <= int(std::ceil(range.high)); ++decade)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double log_value = decade + std::log10(digit);
            if ((digit == 1.0 || few) && log_value >= range.low && log_value <= range.high) values.push_back(log_value);
        }
    return values;
}

std::string axes(const LogPlot& plot, const Frame& frame)
{
    const std::string grid = "stroke=\"#d9dde3\"", axis = "stroke=\"#333\"";
    std::string out;
    for (const double t : ticks(frame.x)) {
        out += line(frame.px(t), top, frame.px(t), height - bottom, grid);
        out += text(frame.px(t), height - bottom + 18, "middle", fmt::format("{:.3g}", std::pow(10, t)));
    }
    for (const double t : ticks(frame.y)) {
        out += line(left, frame.py(t), width - right, frame.py(t), grid);
        out += text(left - 8, frame.py(t) + 4, "end", fmt::format("{:.3g}", std::pow(10, t)));
    }
    out += line(left, height - bottom, width - right, height - bottom, axis) + line(left, top, left, height - bottom, axis);
    out += text((left + width - right) / 2, height - 18, "middle", plot.x_label);
    out += text(0, 0, "middle", plot.y_label, fmt::format("transform=\"translate(22 {:.1f}) rotate(-90)\"", (top + height - bottom) / 2));
    return out + text(left, 26, "start", plot.title, "font-size=\"16\" font-weight=\"600\"");
}

std::string drawn(const Curve& curve, const Frame& frame, std::size_t number)
{
    const char* colour = colours[number % colours.size()];
    std::string path, dots;
    for (std::size_t n = 0; n < std::min(curve.x.size(), curve.y.size()); ++n) {
        if (!(curve.x[n] > 0 && curve.y[n] > 0)) continue;
        const double x = frame.px(std::log10(curve.x[n])), y = frame.py(std::log10(curve.y[n]));
        path += fmt::format("{}{:.1f} {:.1f} ", path.empty() ? "M" : "L", x, y);
        dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", x, y, colour);
    }
    const double y = top + 20 + 20 * double(number);
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", path, colour) + dots +
           fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", width - right + 18, y - 4, colour) +
           text(width - right + 28, y, "start", curve.name);
}

std::string drawn(const Slope& slope, const Frame& frame, std::size_t row)
{
    const double x0 = frame.x.low + 0.15 * (frame.x.high - frame.x.low), x1 = frame.x.high - 0.15 * (frame.x.high - frame.x.low);
    const double xm = (x0 + x1) / 2, ym = (frame.y.low + frame.y.high) / 2;
    const double half = std::min(x1 - xm, (frame.y.high - ym) / std::max(1e-9, std::abs(slope.exponent)));
    const double y = top + 20 + 20 * double(row);
    const std::string style = "stroke=\"#888\" stroke-dasharray=\"5 4\"";
    return line(frame.px(xm - half), frame.py(ym - slope.exponent * half), frame.px(xm + half), frame.py(ym + slope.exponent * half),
                style) +
           line(width - right + 10, y - 4, width - right + 26, y - 4, style) + text(width - right + 30, y, "start", slope.name);
}

} // namespace

std::string to_svg(const LogPlot& plot)
{
    Frame frame;
    for (const Curve& curve : plot.curves)
        for (std::size_t n = 0; n < std::min(curve.x.size(), curve.y.size()); ++n)
            if (curve.x[n] > 0 && curve.y[n] > 0) {
                frame.x.add(curve.x[n]);
                frame.y.add(curve.y[n]);
            }
    frame.x.widen();
    frame.y.widen();
    std::string out = svg::opening(width, height);
    out += axes(plot, frame);
    for (std::size_t n = 0; n < plot.slopes.size(); ++n) out += drawn(plot.slopes[n], frame, plot.curves.size() + n);
    for (std::size_t n = 0; n < plot.curves.size(); ++n) out += drawn(plot.curves[n], frame, n);
    return out + "</svg>\n";
}

} // namespace io
