// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/log_plot.hpp"
#include <doctest/doctest.h>

TEST_CASE("a plot draws each positive point and names its curves")
{
    io::LogPlot plot{"error against time", "core seconds", "error", {{"a & b", {1, 10, 0}, {1e-2, 1e-4, 1}}}, {{-1, "order 1"}}};
    const auto svg = io::to_svg(plot);
    CHECK(svg.find("a &amp; b") != std::string::npos);
    CHECK(svg.find("order 1") != std::string::npos);
    std::size_t dots = 0;
    for (auto at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++dots;
    CHECK(dots == 2 + 1); // two points and the sample in the legend
    CHECK(io::to_svg({}).find("</svg>") != std::string::npos);
}
