// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One round of Jacobi's iteration for implicit viscosity, V x = d inflow(w + x), in as few passes over memory as it takes.
#include "core/field/field.hpp"

namespace physics {

/// Sums of squares over the cells of a block [m8/s2].
struct ViscousSums {
    double residual = 0, change = 0, momentum = 0;
    ViscousSums& operator+=(const ViscousSums& o)
    {
        residual += o.residual;
        change += o.change;
        momentum += o.momentum;
        return *this;
    }
};

/// One component of the equation in a block.
struct ViscousBalance {
    double diffusion;                  ///< d: share * dt * viscosity [m2]
    core::View<const double> volume;   ///< V [m3]
    core::View<const double> velocity; ///< w + x [m/s]
    core::View<const double> change;   ///< x [m/s]
};

/// @param residual  The diffusive inflow [m2/s] in, d inflow - V x [m4/s] out.
[[nodiscard]] ViscousSums form_viscous_residual(const ViscousBalance& balance, core::View<double> residual);

/// Adds residual / diagonal to the velocity and to its change.
/// @param reciprocal  Of the diagonal [1/m3].
void add_jacobi_step(core::View<const double> residual, core::View<const double> reciprocal, core::View<double> velocity,
                     core::View<double> change);

} // namespace physics
