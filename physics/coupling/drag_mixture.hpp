// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Drag on one grain of a mixture of sizes, from a law for equal grains.
#include "physics/coupling/drag.hpp"

namespace physics {

/// Drag over 3 pi mu d phi |u-v| of a grain over that of equal grains of the mean diameter: phi y + C y^2 + 0.064 phi y^3 with
/// y = d / mean, C = 1 - phi. As printed it is 1 + 0.064 phi for equal grains; here it is divided by that, so that they feel the
/// law of equal grains. Fitted for C from 0.1 to 0.6 and ratios to 1:10; where a grain is alone the local mean is its own diameter.
/// @source  van der Hoef, Beetstra, Kuipers (2005), Journal of Fluid Mechanics 528, 233.
[[nodiscard]] inline double mixture_share(double size_ratio, double phi)
{
    const double y = size_ratio, cubic = 0.064 * phi;
    return y * (phi + y * ((1.0 - phi) + cubic * y)) / (1.0 + cubic);
}

/// Drag coefficient of a grain among others of mean diameter `mean` [kg/s].
/// @param law   Of equal grains.
/// @param mean  Sauter diameter of the grains around, sum of d^3 over sum of d^2 [m].
template <class Law>
[[nodiscard]] double drag_in_mixture(const Law& law, const DragInput& in, double mean)
{
    DragInput equal = in;
    equal.diameter = mean;
    const double ratio = in.diameter / mean;
    return law(equal) * ratio * mixture_share(ratio, std::max(in.phi, smallest_closure_fraction));
}

} // namespace physics
