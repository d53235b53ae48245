// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Multigrid: the lists of steps of a set-up and of a cycle, and what each step does.
#include "core/base/error.hpp"
#include "physics/fluid/multigrid.hpp"
#include "physics/fluid/multigrid_coarsen.hpp"
#include "physics/fluid/multigrid_transfer.hpp"

namespace physics {

void Multigrid::add_if_shared(std::vector<MultigridStep>& steps, MultigridStep::Kind kind, int level) const
{
    if (!levels_[std::size_t(level)].mesh.exchanges.empty()) steps.push_back({kind, level});
}

bool Multigrid::lines_meet_ranks(int level) const
{
    const MultigridLevel& l = levels_[std::size_t(level)];
    return l.chains.possible() && l.is_shared;
}

void Multigrid::add_smoothing(std::vector<MultigridStep>& steps, MultigridStep::Kind smooth, MultigridStep::Kind chains, int level) const
{
    steps.push_back({smooth, level});
    if (lines_meet_ranks(level)) steps.push_back({MultigridStep::Kind::send_ends, level});
    if (levels_[std::size_t(level)].chains.possible()) steps.push_back({chains, level});
}

void Multigrid::smooth_down(std::vector<MultigridStep>& steps, int level) const
{
    using K = MultigridStep::Kind;
    add_smoothing(steps, K::smooth_from_zero, K::chains_first_from_zero, level);
    add_if_shared(steps, K::send_other, level);
    add_smoothing(steps, K::smooth_second, K::chains_second, level);
    add_if_shared(steps, K::send_solution, level);
    steps.push_back({K::residual, level});
}

void Multigrid::smooth_up(std::vector<MultigridStep>& steps, int level) const
{
    using K = MultigridStep::Kind;
    add_if_shared(steps, K::send_solution, level);
    add_smoothing(steps, K::smooth_first, K::chains_first, level);
    add_if_shared(steps, K::send_other, level);
    add_smoothing(steps, K::smooth_second, K::chains_second, level);
}

void Multigrid::add_smoother_set_up(std::vector<MultigridStep>& steps, int level) const
{
    using K = MultigridStep::Kind;
    steps.push_back({K::choose_lines, level});
    if (levels_[std::size_t(level)].is_shared) steps.push_back({K::send_choices, level});
    steps.push_back({K::factorise_lines, level});
    if (lines_meet_ranks(level)) steps.push_back({K::send_ports, level});
    if (levels_[std::size_t(level)].chains.possible()) steps.push_back({K::factorise_chains, level});
}

void Multigrid::list_set_up()
{
    using K = MultigridStep::Kind;
    const int last = int(levels_.size()) - 1;
    for (int l = 0; l < last; ++l) {
        add_smoother_set_up(set_up_, l);
        set_up_.push_back({K::end_resistances, l});
        add_if_shared(set_up_, K::send_resistances, l);
        set_up_.push_back({K::coarsen, l});
        if (!levels_[std::size_t(l) + 1].owner.empty()) set_up_.push_back({K::send_coefficients, l + 1});
        set_up_.push_back({K::finish_links, l + 1});
    }
    set_up_.push_back({K::factorise, last});
}

void Multigrid::list_cycle()
{
    using K = MultigridStep::Kind;
    const int last = int(levels_.size()) - 1;
    for (int l = 0; l < last; ++l) {
        smooth_down(cycle_, l);
        cycle_.insert(cycle_.end(), {{K::gather_children, l}, {K::share_inside, l}});
        add_if_shared(cycle_, K::send_parts, l + 1);
        if (!levels_[std::size_t(l) + 1].owner.empty()) cycle_.push_back({K::send_right, l + 1});
        cycle_.push_back({K::share_over_links, l + 1});
    }
    cycle_.push_back({K::coarsest, last});
    for (int l = last - 1; l >= 0; --l) {
        add_if_shared(cycle_, K::send_solution, l + 1);
        cycle_.push_back({K::prolong_up, l});
        smooth_up(cycle_, l);
    }
}

void Multigrid::list_aggregates()
{
    using K = MultigridStep::Kind;
    const bool shared = levels_.front().is_shared;
    auto& set_up = aggregate_set_up_;
    add_smoother_set_up(set_up, 0);
    set_up.push_back({K::join_cells, 0});
    if (shared) set_up.push_back({K::send_counts, 0});
    set_up.push_back({K::number_aggregates, 0});
    add_if_shared(set_up, K::send_parents, 0);
    set_up.push_back({K::tie_aggregates, 0});
    if (shared) set_up.insert(set_up.end(), {{K::send_counts, 0}, {K::send_aggregates, 0}});
    set_up.push_back({K::finish_aggregates, 0});
    smooth_down(aggregate_cycle_, 0);
    aggregate_cycle_.push_back({K::gather_aggregates, 0});
    if (shared) aggregate_cycle_.push_back({K::send_aggregate_right, 0});
    aggregate_cycle_.insert(aggregate_cycle_.end(), {{K::cycle_aggregates, 0}, {K::correct_from_aggregates, 0}});
    smooth_up(aggregate_cycle_, 0);
}

void Multigrid::run(const core::Team& team, const MultigridStep& step)
{
    using K = MultigridStep::Kind;
    auto& level = levels_[std::size_t(step.level)];
    const auto coarse = [&]() -> MultigridLevel& { return levels_[std::size_t(step.level) + 1]; };
    switch (step.kind) {
    case K::choose_lines: // aggregates follow anisotropy by themselves, and bear no lines that run beside what they hold to
        return choose_lines(team, by_coefficients_ ? Smoother::point : options_.smoother, level);
    case K::factorise_lines: return factorise_lines(team, level);
    case K::factorise_chains: return level.chains.factorise(team);
    case K::end_resistances: return link_end_resistances(team, level);
    case K::coarsen: coarsen_coefficients(team, level, coarse()); return coarsen_links(level, coarse());
    case K::finish_links: return finish_links(level);
    case K::factorise: return coarsest_->factorise(level, options_.singular);
    case K::smooth_from_zero: return smooth_from_zero(team, weights(level), level);
    case K::smooth_first: return smooth_first(team, weights(level), level);
    case K::smooth_second: return smooth_second(team, weights(level), level);
    case K::chains_first_from_zero: return finish_from_zero(team, weights(level), level);
    case K::chains_first: return finish_first(team, weights(level), level);
    case K::chains_second: return finish_second(team, weights(level), level);
    case K::residual: return compute_residual(team, level);
    case K::gather_children: return gather_children(team, level, coarse());
    case K::share_inside: return share_inside(team, coarse());
    case K::share_over_links: return share_over_links(team, level);
    case K::coarsest: return coarsest_->solve(level);
    case K::join_cells: return aggregates_.join_cells(team, level);
    case K::number_aggregates: return aggregates_.number(level);
    case K::tie_aggregates: return aggregates_.form_rows(team, level);
    case K::finish_aggregates: return aggregates_.finish(options_.singular);
    case K::gather_aggregates: return aggregates_.gather(team, level);
    case K::cycle_aggregates: return aggregates_.cycle(team);
    case K::correct_from_aggregates: return aggregates_.correct(team, level);
    case K::prolong_up: return prolong_correction(team, coarse(), level);
    default: throw core::Error("multigrid: a step that sends was run instead of started");
    }
}

void Multigrid::start(const MultigridStep& step, const core::Communicator& communicator, core::Pending& pending)
{
    using K = MultigridStep::Kind;
    auto& level = levels_[std::size_t(step.level)];
    switch (step.kind) {
    case K::send_resistances: return messages_.start_resistances(level, communicator, pending);
    case K::send_coefficients: return messages_.start_blocks(level, LevelMessages::Content::coefficients, communicator, pending);
    case K::send_solution: return messages_.start_ghosts(level.mesh, std::span(level.solution), communicator, pending);
    case K::send_other: return messages_.start_ghosts(level.mesh, std::span(level.other), communicator, pending);
    case K::send_parts: return messages_.start_parts(level, communicator, pending);
    case K::send_choices: return messages_.start_choices(level, communicator, pending);
    case K::send_ports: return messages_.start_lines(level, LevelMessages::OfLines::ports, communicator, pending);
    case K::send_ends: return messages_.start_lines(level, LevelMessages::OfLines::ends, communicator, pending);
    case K::send_right: return messages_.start_blocks(level, LevelMessages::Content::right, communicator, pending);
    case K::send_counts: return messages_.start_counts(aggregates_, communicator, pending);
    case K::send_parents: return messages_.start_ghosts(level.mesh, aggregates_.parents(), communicator, pending);
    case K::send_aggregates:
        aggregates_.expect_rows();
        return messages_.start_aggregates(aggregates_, AggregateLevels::Content::rows, communicator, pending);
    case K::send_aggregate_right: return messages_.start_aggregates(aggregates_, AggregateLevels::Content::right, communicator, pending);
    default: throw core::Error("multigrid: a step that sends nothing was started");
    }
}

void Multigrid::complete(const MultigridStep& step, const core::Communicator& communicator)
{
    using K = MultigridStep::Kind;
    auto& level = levels_[std::size_t(step.level)];
    if (step.kind == K::send_resistances) messages_.complete_resistances(level);
    if (step.kind == K::send_parts) messages_.complete_parts(level);
    if (step.kind == K::send_choices) messages_.complete_choices(level);
    if (step.kind == K::send_ports) messages_.complete_lines(level, LevelMessages::OfLines::ports);
    if (step.kind == K::send_ends) messages_.complete_lines(level, LevelMessages::OfLines::ends);
    if (step.kind == K::send_coefficients) messages_.complete_blocks(level, LevelMessages::Content::coefficients, communicator);
    if (step.kind == K::send_right) messages_.complete_blocks(level, LevelMessages::Content::right, communicator);
    if (step.kind == K::send_aggregates) messages_.complete_aggregates(aggregates_, AggregateLevels::Content::rows, communicator);
    if (step.kind == K::send_aggregate_right) messages_.complete_aggregates(aggregates_, AggregateLevels::Content::right, communicator);
}

} // namespace physics
