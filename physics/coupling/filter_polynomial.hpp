// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The polynomial in the Laplacian that smooths as diffusion does: explicit steps, or Chebyshev terms where those are too many.
#include <vector>

namespace physics {

/// With y = 1 - (Laplacian over the largest diagonal entry), which maps densities to averages over neighbours: either the
/// product of (1 - share) + share y over the steps, or the sum of coefficients times T_k(-y). Both have the value 1 at y = 1.
struct FilterPolynomial {
    std::vector<double> steps;             ///< shares in (0, 1]: no kernel of theirs is negative anywhere
    std::vector<double> coefficients{1.0}; ///< used if there are no steps
    [[nodiscard]] int degree() const { return steps.empty() ? int(coefficients.size()) - 1 : int(steps.size()); }
};

/// Shares of explicit steps that sum up to `a`: two of at most 1/2, so that nothing oscillates from cell to cell, and equal ones.
[[nodiscard]] std::vector<double> diffusion_steps(double a);

/// exp(-a (1 + y)) on -1 <= y <= 1 as a sum of Chebyshev polynomials, cut where the rest is below `tolerance` and scaled so
/// that its value at y = -1 is 1.
/// @return coefficients of T_0, T_1, ...
/// @source  Abramowitz & Stegun 9.6.34: the coefficients are modified Bessel functions.
[[nodiscard]] std::vector<double> chebyshev_exponential(double a, double tolerance);

} // namespace physics
