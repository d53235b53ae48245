// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Curves on two logarithmic axes as an SVG picture: error against run time, error against step.
#include <string>
#include <vector>

namespace io {

struct Curve {
    std::string name;
    std::vector<double> x, y; ///< positive
};

/// A straight line y ~ x^slope drawn dashed for comparison, through the middle of the picture.
struct Slope {
    double exponent;
    std::string name;
};

struct LogPlot {
    std::string title, x_label, y_label;
    std::vector<Curve> curves;
    std::vector<Slope> slopes;
};

/// @return the SVG text. Points that are not positive are left out.
[[nodiscard]] std::string to_svg(const LogPlot& plot);

} // namespace io
