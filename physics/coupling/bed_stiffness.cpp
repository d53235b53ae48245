// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/bed_stiffness.hpp"
#include <algorithm>
#include <numbers>

namespace physics {

double bed_layers(const core::Domain& domain, const core::Vec3& gravity, double solid_volume, double diameter)
{
    constexpr double packed = 0.5;
    const double volume = domain.size.prod();
    const auto height = [&](int axis) { return std::min(1.0, solid_volume / (packed * volume)) * domain.size[axis]; };
    int down = 0;
    if (gravity.norm() > 0) {
        gravity.cwiseAbs().maxCoeff(&down);
        if (!domain.periodic[std::size_t(down)]) return std::max(1.0, height(down) / diameter);
    }
    double nearest = 0.0;
    for (int a = 0; a < 3; ++a)
        if (!domain.periodic[std::size_t(a)] && (nearest == 0.0 || height(a) < nearest)) nearest = height(a);
    return std::max(1.0, nearest / diameter);
}

double bed_stiffness(double layer, double layers)
{
    const double wave = 0.5 * std::numbers::pi / layers;
    return layer * std::min(1.0, wave * wave);
}

} // namespace physics
