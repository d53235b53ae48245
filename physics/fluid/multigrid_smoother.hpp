// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Chebyshev(2) smoothing with point- or line-Jacobi: additive, hence the same for any order of blocks.
#include "core/base/team.hpp"
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// A step of the Chebyshev iteration on [largest / ratio, largest]: d = keep d + gain z, x += d; z is the Jacobi correction of the
/// residual.
struct ChebyshevStep {
    float keep, gain;
};
/// @source  Saad, Iterative Methods for Sparse Linear Systems (2003), algorithm 12.1.
template <int Degree>
[[nodiscard]] std::array<ChebyshevStep, Degree> chebyshev_steps(double largest, double ratio)
{
    const double middle = 0.5 * (largest + largest / ratio), half_width = 0.5 * (largest - largest / ratio);
    double rho = half_width / middle;
    std::array<ChebyshevStep, Degree> steps{{{0.0F, float(1.0 / middle)}}};
    for (std::size_t n = 1; n < Degree; ++n) {
        const double next = 1.0 / (2.0 * middle / half_width - rho);
        steps[n] = {float(next * rho), float(2.0 * next / half_width)};
        rho = next;
    }
    return steps;
}

/// Coefficients of the second-degree Chebyshev iteration.
/// First step: d = first z; second: d = keep d + second z; z is the Jacobi correction of the residual.
struct ChebyshevWeights {
    float first, keep, second;
};
/// @param largest  Bound of the eigenvalues of the Jacobi-preconditioned matrix: 2 holds for every symmetric M-matrix,
///                 for points and for lines.
[[nodiscard]] ChebyshevWeights chebyshev_weights(double largest, double ratio);

/// The second-degree polynomial with one root at 1, (1 - x)(1 - x / 1.5). Where lines are tied a thousand times more firmly along
/// than across, what interpolation leaves along them has this eigenvalue and a thousand times the energy of what it corrects: only a
/// root there takes it away. In between it damps less than Chebyshev's.
[[nodiscard]] ChebyshevWeights weights_for_firm_lines();

/// Chooses the lines of each block.
void choose_lines(const core::Team& team, Smoother kind, MultigridLevel& level);
/// Ties lines that go on in other blocks, and factorises all. @pre The choices of all blocks are known.
void factorise_lines(const core::Team& team, MultigridLevel& level);

/// First step from a zero solution: writes direction and `other`. Blocks with chains leave that to finish_from_zero(), which comes
/// when the ends of lines on other ranks are known; so do the two below.
void smooth_from_zero(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);
void finish_from_zero(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);
/// First step from `solution`: writes direction and `other`.
void smooth_first(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);
void finish_first(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);
/// Second step from `other`: updates direction, writes `solution`.
void smooth_second(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);
void finish_second(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level);

} // namespace physics
