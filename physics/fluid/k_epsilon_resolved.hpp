// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The k-epsilon model that holds down to the wall, for grids that resolve the layers there: formulas of one place.
#include "physics/fluid/k_epsilon.hpp"

namespace physics {

/// @source  Abe, Kondoh & Nagano, Int. J. Heat Mass Transfer 37 (1994) 139, eqs (10)-(16).
struct ResolvedConstants {
    double c_mu = 0.09, c_1 = 1.5, c_2 = 1.9, sigma_k = 1.4, sigma_epsilon = 1.4;
};
inline constexpr ResolvedConstants k_epsilon_resolved{};

/// What nearness of a wall leaves of the model's constants: 1 far from all walls. No more than 1 is left: where k vanishes before
/// epsilon does, as at the start, the formula grows without bounds, and epsilon with it.
struct WallDamping {
    double viscosity, decay;
};

/// Speeds are those of the smallest eddies, (nu epsilon)^(1/4), which do not vanish where the flow turns back.
/// @param y  Distance from the nearest wall [m].
[[nodiscard]] inline WallDamping wall_damping(double k, double epsilon, double y, double viscosity)
{
    const double turbulence = k * k / (viscosity * epsilon), distance = std::sqrt(std::sqrt(viscosity * epsilon)) * y / viscosity;
    const double far = -std::expm1(-distance / 14), near = -std::expm1(-distance / 3.1);
    const double strong = turbulence / 200, weak = turbulence / 6.5;
    return {std::min(1.0, far * far * (1 + 5 * std::exp(-strong * strong) / std::sqrt(turbulence * std::sqrt(turbulence)))),
            near * near * (1 - 0.3 * std::exp(-weak * weak))};
}

/// What becomes of k in the viscous layer, per k: there epsilon is 2 nu k / y^2 [1/s].
[[nodiscard]] inline double viscous_decay(double y, double viscosity) { return 2 * viscosity / (y * y); }

} // namespace physics
