// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/time_step.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace physics {

double largest_speed(const core::ParticleSet& grains)
{
    double square = 0;
    for (int g = 0; g < grains.owned; ++g) square = std::max(square, grains.velocity_of(g).squaredNorm());
    return std::sqrt(square);
}

double grain_move_limit(double share, double filter_width, double speed, double acceleration)
{
    if (filter_width <= 0) return std::numeric_limits<double>::infinity();
    return time_to_reach(share * filter_width, speed, acceleration);
}

} // namespace physics
