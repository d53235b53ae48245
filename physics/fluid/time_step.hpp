// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long a step may be.
#include "core/grid/geometry.hpp"
#include <limits>
#include <string_view>

namespace physics {

/// Largest rates in a block.
struct TransportRates {
    double displacement = 0; ///< cells per second, along one axis
    double distortion = 0;   ///< difference of that between neighbouring cells [1/s]
};

/// From the interior alone: a function of the state, without messages.
[[nodiscard]] TransportRates transport_rates(const core::BlockGeometry& geometry, core::VectorView<const double> velocity);

struct TimeStepOptions {
    double largest = std::numeric_limits<double>::infinity(); ///< [s]
    double displacement = 0.9; ///< cells per step; the stencils reach one cell
    double distortion = 0.5;   ///< below 1 trajectories do not cross
};

struct TimeStepLimit {
    double dt;                ///< [s]
    std::string_view binding; ///< "largest", "displacement" or "distortion"
};

[[nodiscard]] TimeStepLimit time_step_limit(const TransportRates& rates, const TimeStepOptions& options);

} // namespace physics
