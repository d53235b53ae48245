// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long a step may be.
#include "core/grid/geometry.hpp"
#include <algorithm>
#include <limits>
#include <string_view>

namespace physics {

/// Largest rates in a block.
struct TransportRates {
    double displacement = 0;   ///< cells per second, along one axis
    double distortion = 0;     ///< difference of that between neighbouring cells [1/s]
    double growth = 0;         ///< of displacement by what pulls the fluid [cells/s2]
    double outflow = 0;        ///< share of the fluid of a cell that leaves it per second; finite volumes alone need it [1/s]
    double outflow_growth = 0; ///< of that by what pulls the fluid [1/s2]

    /// Takes in the rates of another block.
    void widen(const TransportRates& other)
    {
        displacement = std::max(displacement, other.displacement);
        distortion = std::max(distortion, other.distortion);
        growth = std::max(growth, other.growth);
        outflow = std::max(outflow, other.outflow);
        outflow_growth = std::max(outflow_growth, other.outflow_growth);
    }
};

/// From the interior alone: a function of the state, without messages.
/// @param pull  Acceleration that the fluid may get, in magnitude along each axis [m/s2].
[[nodiscard]] TransportRates transport_rates(const core::BlockGeometry& geometry, core::VectorView<const double> velocity,
                                             const core::Vec3& pull = core::Vec3::Zero());

/// Longest time in which a way rate dt + growth dt^2 stays within bound.
[[nodiscard]] double time_to_reach(double bound, double rate, double growth);

struct TimeStepOptions {
    double largest = std::numeric_limits<double>::infinity(); ///< [s]
    double displacement = 0.9;                                ///< cells per step; the stencils reach one cell
    double distortion = 0.5;                                  ///< below 1 trajectories do not cross
    double outflow = 1;                                       ///< share of the fluid of a cell; stable to 1.35 (momentum_transport.hpp)
};

struct TimeStepLimit {
    double dt;                ///< [s]
    std::string_view binding; ///< "largest", "displacement" or "distortion", or the name of another limit
    /// Becomes another limit if that is shorter.
    void tighten(double other, std::string_view name)
    {
        if (other < dt) *this = {other, name};
    }
};

[[nodiscard]] TimeStepLimit time_step_limit(const TransportRates& rates, const TimeStepOptions& options);
/// The same for finite volumes, which trace no paths: how much of the fluid of a cell may leave it.
[[nodiscard]] TimeStepLimit outflow_step_limit(const TransportRates& rates, const TimeStepOptions& options);

} // namespace physics
