// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A cycle over levels of aggregates. Large levels are visited twice, with the best combination of both corrections: then a hierarchy
// converges nearly as two levels do, however many there are. All ranks have all nodes, so that sums over them need no message.
#include "physics/fluid/graph_level.hpp"
#include "physics/fluid/sparse_factors.hpp"
#include <span>

namespace physics {

class GraphCycle {
public:
    /// @param coarsest  Factors of the last level.
    GraphCycle(const core::Team& team, std::span<GraphLevel> levels, SparseFactors& coarsest)
        : team_(team), levels_(levels), coarsest_(coarsest)
    {
    }
    /// Approximates the solution of a level from its right-hand side, which is used up.
    /// @return How many times the solution is to be taken on the next finer level.
    float solve(std::size_t level);

private:
    void visit(std::size_t level);
    void solve_coarsest();
    void visit_again(std::size_t level);

    const core::Team& team_;
    std::span<GraphLevel> levels_;
    SparseFactors& coarsest_;
};

} // namespace physics
