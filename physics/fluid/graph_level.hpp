// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A level of aggregates: its graph, the vectors of a V-cycle, and its smoother.
#include "core/base/team.hpp"
#include "physics/fluid/graph_matrix.hpp"
#include <vector>

namespace physics {

struct GraphLevel {
    GraphMatrix matrix;
    std::vector<int> parent; ///< of each node its aggregate on the next level; -1: none
    std::vector<float> inverse, right, residual, direction, solution;

    explicit GraphLevel(GraphMatrix m);
    [[nodiscard]] std::size_t bytes() const;
};

/// Writes the residual of `solution`.
void form_residual(const core::Team& team, GraphLevel& level);
/// Chebyshev iteration with point-Jacobi; from zero the first residual is the right-hand side.
void smooth_from_zero(const core::Team& team, GraphLevel& level);
void smooth(const core::Team& team, GraphLevel& level);

/// The next level: nodes that hold together joined, conductances between aggregates added up.
/// @return Nothing is joined any more if it has as many nodes.
[[nodiscard]] GraphLevel coarsened(GraphLevel& fine);

/// Corrections of aggregates are piecewise constant: too stiff for smooth errors, hence taken so many times.
/// @source  Braess, Computing 55 (1995) 379: 1.8 where coefficients are even; jumps bear less.
inline constexpr float over_correction = 1.3F;

} // namespace physics
