// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Geometric multigrid over structured blocks: a V-cycle in 32 bits, the preconditioner of pressure, viscosity and filter.
// Symbolic set-up once per mesh, numeric set-up each step. A cycle is a fixed list of steps, so that whoever runs it can
// wait for messages between two steps in the way that suits it.
#include "core/base/team.hpp"
#include "physics/fluid/coarsest_solver.hpp"
#include "physics/fluid/multigrid_messages.hpp"
#include "physics/fluid/multigrid_smoother.hpp"
#include <span>
#include <vector>

namespace physics {

/// What coarse levels follow.
enum class Coarsening {
    automatic,    ///< the coefficients where neighbours differ so much that the grid would mislead
    grid,         ///< every second grid line
    coefficients, ///< aggregates of cells that hold together
};

struct MultigridOptions {
    int coarsest_cells = 400;     ///< solved directly below this number
    int replicated_cells = 16384; ///< levels of at most this size are computed by every rank: less than a message costs
    Smoother smoother = Smoother::automatic;
    Coarsening coarsening = Coarsening::automatic;
    double spectrum_ratio = 8.0; ///< the smoother damps the eigenvalues from 2 / ratio to 2
    bool shifted = false;        ///< the operator has a shift
    bool singular = true;        ///< no shift and no wall that holds the unknown
};

/// Asks for the same grids with a shift.
struct WithShift {};

/// Part of the set-up or of a cycle. A step that sends is started, and completed when its messages have arrived.
struct MultigridStep {
    enum class Kind {
        choose_lines,
        factorise_lines,
        factorise_chains,
        end_resistances,
        coarsen,
        finish_links,
        factorise,
        join_cells,
        number_aggregates,
        tie_aggregates,
        finish_aggregates, // set-up
        send_resistances,
        send_coefficients,
        send_choices,
        send_counts,
        send_parents,
        send_aggregates,
        send_ports, // set-up, messages
        smooth_from_zero,
        chains_first_from_zero,
        smooth_second,
        chains_second,
        residual,
        gather_children,
        share_inside,
        share_over_links, // cycle, down
        coarsest,
        gather_aggregates,
        cycle_aggregates,
        correct_from_aggregates,
        prolong_up,
        smooth_first,
        chains_first, // cycle, up
        send_solution,
        send_other,
        send_parts,
        send_right,
        send_aggregate_right,
        send_ends // cycle, messages
    };
    Kind kind;
    int level;
    [[nodiscard]] bool sends() const { return (kind >= Kind::send_resistances && kind <= Kind::send_ports) || kind >= Kind::send_solution; }
};

/// What coefficients are like, to be agreed on by all ranks: the maximum of each number.
struct CoefficientRange {
    double largest = 0.0;
    double jumps = 0.0; ///< 1 where some neighbouring faces across the same axis differ by more than `sharp`, else 0
    [[nodiscard]] std::array<double, 2> numbers() const { return {largest, jumps}; }
    /// Less costs conjugate gradients with the grid's levels at most 100 iterations or so: no more time than to join cells.
    static constexpr double sharp = 300.0;
};

class Multigrid {
public:
    /// Collective over `communicator`.
    Multigrid(const BlockTopology& topology, const MultigridOptions& options,
              const core::Communicator& communicator = core::Communicator::self());
    /// The same grids for an operator with a shift, which is not singular. No message.
    Multigrid(const Multigrid& other, WithShift);
    ~Multigrid();
    Multigrid(Multigrid&&) noexcept;

    /// Flat arrays of the finest level, in which right-hand sides and solutions are given.
    [[nodiscard]] const LevelMesh& mesh() const { return levels_.front().mesh; }
    [[nodiscard]] const std::vector<MultigridLevel>& levels() const { return levels_; }
    /// For each canonical link its number in BlockTopology::links.
    [[nodiscard]] std::span<const int> link_source() const { return link_source_; }

    /// Coefficients of the finest level, in 64 bits as the Krylov operator uses them; they are scaled before they are
    /// rounded. Run set_up_steps() next.
    /// @param range  Of all ranks.
    void load(const core::Team& team, const SevenPoint<double>& fine, const CoefficientRange& range);
    [[nodiscard]] std::span<const MultigridStep> set_up_steps() const { return by_coefficients_ ? aggregate_set_up_ : set_up_; }
    [[nodiscard]] std::span<const MultigridStep> cycle_steps() const { return by_coefficients_ ? aggregate_cycle_ : cycle_; }
    /// Do coarse levels follow the coefficients, since the last load()?
    [[nodiscard]] bool by_coefficients() const { return by_coefficients_; }

    /// right = residual * scale, rounded to 32 bits.
    void load_right(const core::Team& team, std::span<const double> residual, double scale);
    /// correction = solution of the cycle, scaled back.
    void store_solution(const core::Team& team, std::span<double> correction) const;

    /// A step that does not send.
    void run(const core::Team& team, const MultigridStep& step);
    /// A step that sends; complete() it when `pending` is done.
    void start(const MultigridStep& step, const core::Communicator& communicator, core::Pending& pending);
    void complete(const MultigridStep& step, const core::Communicator& communicator);

    [[nodiscard]] std::size_t bytes() const;

private:
    [[nodiscard]] const ChebyshevWeights& weights(const MultigridLevel& level) const
    {
        return level.lines_are_firm ? firm_weights_ : weights_;
    }
    /// Gives coarse levels of the grid their memory, or takes it where aggregates are used instead.
    void keep_grids();
    void list_set_up();
    void list_cycle();
    void list_aggregates();
    /// What smoothers of a level need.
    void add_smoother_set_up(std::vector<MultigridStep>& steps, int level) const;
    /// Do lines of a level go on, or could they, in blocks of other ranks?
    [[nodiscard]] bool lines_meet_ranks(int level) const;
    /// A part of the smoothing, and what chains of lines add to it.
    void add_smoothing(std::vector<MultigridStep>& steps, MultigridStep::Kind smooth, MultigridStep::Kind chains, int level) const;
    void smooth_down(std::vector<MultigridStep>& steps, int level) const;
    void smooth_up(std::vector<MultigridStep>& steps, int level) const;
    void add_if_shared(std::vector<MultigridStep>& steps, MultigridStep::Kind kind, int level) const;

    MultigridOptions options_;
    ChebyshevWeights weights_, firm_weights_;
    std::vector<int> link_source_;
    std::vector<MultigridLevel> levels_;
    std::unique_ptr<CoarsestSolver> coarsest_;
    LevelMessages messages_;
    AggregateLevels aggregates_;
    bool by_coefficients_ = false, has_grids_ = true; ///< the latter: coarse levels of the grid have their memory
    std::vector<MultigridStep> set_up_, cycle_, aggregate_set_up_, aggregate_cycle_;
    double coefficient_scale_ = 1.0, right_scale_ = 1.0;
};

/// On this rank.
[[nodiscard]] CoefficientRange coefficient_range(const LevelMesh& mesh, const SevenPoint<double>& a);
/// The power of two that brings `largest` into [1, 2); 1 for 0.
[[nodiscard]] double power_of_two_scale(double largest);

/// Runs all steps and waits for messages on the spot: for one rank, and for set-ups outside the task graph. Collective.
void run_steps(const core::Team& team, const core::Communicator& communicator, Multigrid& multigrid, std::span<const MultigridStep> steps);

} // namespace physics
