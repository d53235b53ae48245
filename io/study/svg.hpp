// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pieces of SVG that plots are made of.
#include <array>
#include <fmt/format.h>
#include <string>

namespace io::svg {

inline constexpr std::array<const char*, 6> colours{"#1f6f8b", "#d1603d", "#5b8c5a", "#8d5a97", "#c7a252", "#555b6e"};

/// The same text in XML and HTML.
[[nodiscard]] inline std::string escaped(const std::string& text)
{
    std::string out;
    for (char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

[[nodiscard]] inline std::string text(double x, double y, const std::string& anchor, const std::string& words,
                                      const std::string& extra = "")
{
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, extra, escaped(words));
}

[[nodiscard]] inline std::string line(double x0, double y0, double x1, double y1, const std::string& style)
{
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x0, y0, x1, y1, style);
}

/// The opening tag and a white ground.
[[nodiscard]] inline std::string opening(double width, double height)
{
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
                       "font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
                       width, height);
}

} // namespace io::svg
