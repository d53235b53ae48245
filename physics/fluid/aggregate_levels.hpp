// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Coarse levels below the finest that follow the coefficients instead of the grid: aggregates of cells that hold together firmly, for
// coefficients that jump so much between neighbours that every second grid line says nothing. Cells are joined within their blocks, on
// the ranks that own them; from the first level of aggregates on every rank has them all.
#include "core/base/team.hpp"
#include "physics/fluid/aggregation.hpp"
#include "physics/fluid/graph_level.hpp"
#include "physics/fluid/multigrid_level.hpp"
#include "physics/fluid/sparse_factors.hpp"

namespace physics {

class AggregateLevels {
public:
    /// @param owner  Rank of every block.
    AggregateLevels(std::vector<int> owner, int coarsest_nodes) : owner_(std::move(owner)), coarsest_nodes_(coarsest_nodes) {}

    /// The same blocks, nothing joined.
    [[nodiscard]] AggregateLevels like() const { return {owner_, coarsest_nodes_}; }

    // Set-up, in this order.
    /// Joins the cells of the blocks of this rank.
    void join_cells(const core::Team& team, MultigridLevel& finest);
    /// Aggregates of each block of all ranks, -1 where not known: their maximum over the ranks comes next.
    [[nodiscard]] std::span<double> counts() { return counts_; }
    /// Numbers aggregates block by block.
    void number(const MultigridLevel& finest);
    /// Aggregate of each flat place of the finest level; those of ghosts are to be filled in.
    [[nodiscard]] std::span<int> parents() { return parent_; }
    /// What the aggregates of this rank's blocks are tied to. Their number of ties, for all blocks, in counts().
    void form_rows(const core::Team& team, const MultigridLevel& finest);
    /// Joins aggregates to the coarsest level and factorises that. @pre The rows of all blocks are known.
    void finish(bool singular);

    // A cycle: the residual of the finest level down, the correction of its solution up.
    void gather(const core::Team& team, const MultigridLevel& finest);
    /// @pre The right-hand sides of all blocks are known.
    void cycle(const core::Team& team);
    void correct(const core::Team& team, MultigridLevel& finest) const;

    /// What owners of blocks send to all other ranks.
    enum class Content { rows, right };
    /// Calls body(pointer, number of 4-byte words) for all that is known, or to be known, of the blocks of a rank.
    template <class Body>
    void for_content(Content content, int rank, Body body)
    {
        for (std::size_t b = 0; b < owner_.size(); ++b) {
            if (owner_[b] != rank) continue;
            if (content == Content::right) {
                body(levels_.front().right.data() + first_node_[b], std::size_t(first_node_[b + 1] - first_node_[b]));
                continue;
            }
            GraphMatrix& rows = rows_[b];
            body(rows.first.data(), rows.first.size());
            body(rows.other.data(), rows.other.size());
            body(rows.conductance.data(), rows.conductance.size());
            body(rows.shift.data(), rows.shift.size());
        }
    }
    /// Makes room for the rows of other ranks. @pre counts() holds the numbers of ties of all blocks.
    void expect_rows();

    [[nodiscard]] std::size_t levels() const { return levels_.size(); }
    [[nodiscard]] std::size_t bytes() const;

private:
    std::vector<int> owner_;
    int coarsest_nodes_;
    std::vector<double> counts_;
    std::vector<int> parent_;
    std::vector<int> first_node_;   ///< of each block on the first level, and the end
    std::vector<GraphMatrix> rows_; ///< of each block, during the set-up
    std::vector<GraphLevel> levels_;
    float gain_ = 1.0F; ///< how many times the solution of the first level is to be taken
    SparseFactors factors_;
    std::vector<MatrixEntry> entries_;
};

} // namespace physics
