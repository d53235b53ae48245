// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/control_functions.hpp"
#include <cmath>

namespace core {

ControlFunctions no_control(Extents vertices)
{
    ControlFunctions control;
    for (auto* arrays : {&control.source, &control.factor})
        for (auto& array : *arrays) array = Array3<double>(vertices, 0, 0.0);
    return control;
}

void add_attraction(const Attraction& attraction, ControlFunctions& control)
{
    for_each_cell(control.factor[0].extents(), [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        double square = 0;
        for (int m = 0; m < 3; ++m)
            if (const auto place = attraction.at[std::size_t(m)]) square += (c[m] - *place) * (c[m] - *place);
        const double pull = attraction.strength * std::exp(-std::sqrt(square) / attraction.reach);
        for (int m = 0; m < 3; ++m) {
            const auto place = attraction.at[std::size_t(m)];
            if (place && c[m] != *place) control.factor[std::size_t(m)](i, j, k) -= c[m] > *place ? pull : -pull;
        }
    });
}

std::vector<double> factors_of(const std::vector<double>& shares, Curvature kind)
{
    std::vector<Vec3> points, slopes(shares.size()), curvatures(shares.size());
    for (const double share : shares) points.emplace_back(share, 0, 0);
    line_slopes(points, slopes);
    line_curvatures(points, kind, curvatures);
    std::vector<double> factors;
    for (std::size_t i = 0; i < shares.size(); ++i) factors.push_back(-curvatures[i].x() / slopes[i].x());
    return factors;
}

} // namespace core
