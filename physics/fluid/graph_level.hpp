// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A level of aggregates: its graph, the vectors of a V-cycle, and its smoother.
#include "core/base/team.hpp"
#include "physics/fluid/graph_matrix.hpp"
#include <vector>

namespace physics {

struct GraphLevel {
    static constexpr int grain = 4096; ///< nodes of a chunk

    GraphMatrix matrix;
    std::vector<int> parent; ///< of each node its aggregate on the next level; -1: none
    std::vector<float> inverse, right, residual, direction, solution;
    std::vector<float> first_solution, first_image; ///< of the first of two visits; empty where there is one
    std::vector<double> parts;                      ///< of sums, one for each chunk

    explicit GraphLevel(GraphMatrix m);
    void expect_two_visits();
    [[nodiscard]] bool is_visited_twice() const { return !first_solution.empty(); }
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

/// From the residual of a level to the right-hand side of the next, and from the solution of the next to a correction.
void restrict_residual(const GraphLevel& fine, GraphLevel& coarse);
void add_correction(const GraphLevel& coarse, float gain, GraphLevel& fine);

/// Corrections of aggregates are piecewise constant: too stiff for smooth errors, hence taken so many times where a level is visited once.
/// @source  Braess, Computing 55 (1995) 379: 1.8 where coefficients are even; jumps bear less.
inline constexpr float over_correction = 1.3F;

} // namespace physics
