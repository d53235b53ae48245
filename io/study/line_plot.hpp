// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Curves on two linear axes as an SVG picture.
#include "io/study/log_plot.hpp"

namespace io {

/// Curves share both axes; numbers of any sign.
struct LinePlot {
    std::string title, x_label, y_label;
    std::vector<Curve> curves;
};

/// @return the SVG text. Points that are not finite are left out; long curves are thinned to what can be seen, each
///         thinned stretch keeping its lowest and highest value.
[[nodiscard]] std::string to_svg(const LinePlot& plot);

} // namespace io
