// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid.hpp"

#include "core/base/error.hpp"
#include "physics/fluid/multigrid_coarsen.hpp"
#include "physics/fluid/multigrid_transfer.hpp"
#include <algorithm>
#include <cmath>

namespace physics {
Multigrid::Multigrid(const BlockTopology& topology, const MultigridOptions& options, const core::Communicator& communicator)
    : options_(options), weights_(chebyshev_weights(2.0, options.spectrum_ratio)), firm_weights_(weights_for_firm_lines())
{
    BlockTopology level = topology;
    level.links = canonical_links(topology.links, link_source_);
    const auto self = core::Communicator::self();
    levels_.push_back(make_multigrid_level(level, options.shifted, communicator));
    bool split = communicator.size() > 1;
    for (bool last = false; !last;) { // at least two levels: the finest stays with its owners, the coarsest is everywhere
        std::vector<CoarseLink> coarse_link;
        BlockTopology next = coarsened(level, coarse_link);
        const auto cells = cell_count(next);
        last = cells <= options.coarsest_cells || cells == cell_count(coarsened(next));
        const bool gathers = split && (last || cells <= options.replicated_cells);
        if (gathers) next = replicated(next, communicator, coarse_link);
        levels_.back().mesh.coarse_link = std::move(coarse_link);
        split = split && !gathers;
        levels_.push_back(make_multigrid_level(next, options.shifted, split ? communicator : self));
        if (gathers) levels_.back().owner = topology.owner;
        tie_levels(levels_[levels_.size() - 2], levels_.back());
        level = std::move(next);
    }
    coarsest_ = std::make_unique<CoarsestSolver>(levels_.back().mesh);
    list_set_up();
    list_cycle();
}

Multigrid::Multigrid(const Multigrid& other, WithShift)
    : options_(other.options_),
      weights_(other.weights_),
      firm_weights_(other.firm_weights_),
      link_source_(other.link_source_),
      levels_(other.levels_),
      coarsest_(std::make_unique<CoarsestSolver>(levels_.back().mesh)),
      set_up_(other.set_up_),
      cycle_(other.cycle_)
{
    options_.shifted = true;
    options_.singular = false;
    for (MultigridLevel& level : levels_) level.matrix.shift.assign(level.mesh.layout.size(), 0.0F);
}

Multigrid::~Multigrid() = default;
Multigrid::Multigrid(Multigrid&&) noexcept = default;

void Multigrid::add_if_shared(std::vector<MultigridStep>& steps, MultigridStep::Kind kind, int level) const
{
    if (!levels_[std::size_t(level)].mesh.exchanges.empty()) steps.push_back({kind, level});
}

bool Multigrid::lines_meet_ranks(int level) const
{
    const MultigridLevel& l = levels_[std::size_t(level)];
    return l.chains.possible() && l.is_shared;
}

void Multigrid::add_smoothing(MultigridStep::Kind smooth, MultigridStep::Kind chains, int level)
{
    cycle_.push_back({smooth, level});
    if (lines_meet_ranks(level)) cycle_.push_back({MultigridStep::Kind::send_ends, level});
    if (levels_[std::size_t(level)].chains.possible()) cycle_.push_back({chains, level});
}

void Multigrid::list_set_up()
{
    using K = MultigridStep::Kind;
    const int last = int(levels_.size()) - 1;
    for (int l = 0; l < last; ++l) {
        set_up_.push_back({K::choose_lines, l});
        if (levels_[std::size_t(l)].is_shared) set_up_.push_back({K::send_choices, l});
        set_up_.insert(set_up_.end(), {{K::factorise_lines, l}, {K::end_resistances, l}});
        if (lines_meet_ranks(l)) set_up_.push_back({K::send_ports, l});
        if (levels_[std::size_t(l)].chains.possible()) set_up_.push_back({K::factorise_chains, l});
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
        add_smoothing(K::smooth_from_zero, K::chains_first_from_zero, l);
        add_if_shared(cycle_, K::send_other, l);
        add_smoothing(K::smooth_second, K::chains_second, l);
        add_if_shared(cycle_, K::send_solution, l);
        cycle_.insert(cycle_.end(), {{K::residual, l}, {K::gather_children, l}, {K::share_inside, l}});
        add_if_shared(cycle_, K::send_parts, l + 1);
        if (!levels_[std::size_t(l) + 1].owner.empty()) cycle_.push_back({K::send_right, l + 1});
        cycle_.push_back({K::share_over_links, l + 1});
    }
    cycle_.push_back({K::coarsest, last});
    for (int l = last - 1; l >= 0; --l) {
        add_if_shared(cycle_, K::send_solution, l + 1);
        cycle_.push_back({K::prolong_up, l});
        add_if_shared(cycle_, K::send_solution, l);
        add_smoothing(K::smooth_first, K::chains_first, l);
        add_if_shared(cycle_, K::send_other, l);
        add_smoothing(K::smooth_second, K::chains_second, l);
    }
}

void Multigrid::load(const core::Team& team, const SevenPoint<double>& fine, double scale)
{
    coefficient_scale_ = scale;
    auto& level = levels_.front();
    const auto rounded = [scale](double v) { return float(scale * v); };
    level.mesh.layout.for_pieces(team, [&](int n) {
        const auto& p = level.mesh.layout.pieces()[std::size_t(n)];
        const auto copy = [&](const std::vector<double>& from, std::vector<float>& to) {
            std::transform(from.begin() + p.begin, from.begin() + p.end, to.begin() + p.begin, rounded);
        };
        for (std::size_t axis = 0; axis < 3; ++axis) copy(fine.face[axis], level.matrix.face[axis]);
        if (options_.shifted) copy(fine.shift, level.matrix.shift);
    });
    std::transform(fine.link.begin(), fine.link.end(), level.matrix.link.begin(), rounded);
    spread_links(level);
}

void Multigrid::load_right(const core::Team& team, std::span<const double> residual, double scale)
{
    right_scale_ = scale;
    auto& level = levels_.front();
    level.mesh.layout.for_pieces(team, [&](int n) {
        const auto& p = level.mesh.layout.pieces()[std::size_t(n)];
        const double* from = residual.data();
        float* to = level.right.data();
#pragma omp simd
        for (auto c = p.begin; c < p.end; ++c) to[c] = float(scale * from[c]);
    });
}

void Multigrid::store_solution(const core::Team& team, std::span<double> correction) const
{
    const auto& level = levels_.front();
    level.mesh.layout.for_pieces(team, [&, scale = coefficient_scale_ / right_scale_](int n) {
        const auto& p = level.mesh.layout.pieces()[std::size_t(n)];
        const float* from = level.solution.data();
        double* to = correction.data();
#pragma omp simd
        for (auto c = p.begin; c < p.end; ++c) to[c] = scale * double(from[c]);
    });
}

void Multigrid::run(const core::Team& team, const MultigridStep& step)
{
    using K = MultigridStep::Kind;
    auto& level = levels_[std::size_t(step.level)];
    const auto coarse = [&]() -> MultigridLevel& { return levels_[std::size_t(step.level) + 1]; };
    switch (step.kind) {
    case K::choose_lines: return choose_lines(team, options_.smoother, level);
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
}

std::size_t Multigrid::bytes() const
{
    std::size_t sum = 0;
    for (const auto& l : levels_) sum += l.bytes();
    return sum;
}

double largest_coefficient(const LevelMesh& mesh, const SevenPoint<double>& a)
{
    double largest = 0.0;
    for (const auto& p : mesh.layout.pieces())
        for (auto c = std::size_t(p.begin); c < std::size_t(p.end); ++c)
            largest = std::max({largest, a.face[0][c], a.face[1][c], a.face[2][c], a.shift.empty() ? 0.0 : a.shift[c]});
    return a.link.empty() ? largest : std::max(largest, *std::max_element(a.link.begin(), a.link.end()));
}

double power_of_two_scale(double largest)
{
    if (!(largest > 0.0) || !std::isfinite(largest)) return 1.0;
    return std::ldexp(1.0, -std::ilogb(largest));
}

void run_steps(const core::Team& team, const core::Communicator& communicator, Multigrid& multigrid, std::span<const MultigridStep> steps)
{
    for (const auto& step : steps) {
        if (!step.sends()) {
            multigrid.run(team, step);
            continue;
        }
        core::Pending pending;
        multigrid.start(step, communicator, pending);
        pending.wait();
        multigrid.complete(step, communicator);
    }
}

} // namespace physics
