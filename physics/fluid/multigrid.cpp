// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid.hpp"

#include "physics/fluid/multigrid_coarsen.hpp"
#include "physics/fluid/multigrid_transfer.hpp"
#include <algorithm>
#include <cmath>

namespace physics {
namespace {

/// Blocks of this rank on both levels, matched by their ids.
void match_blocks(MultigridLevel& fine, MultigridLevel& coarse)
{
    coarse.fine_block.assign(std::size_t(coarse.mesh.layout.blocks()), -1);
    for (core::LocalBlock b = 0; b < fine.mesh.layout.blocks(); ++b) {
        const auto ids = coarse.mesh.layout.ids();
        const auto at = std::lower_bound(ids.begin(), ids.end(), fine.mesh.layout.id(b)) - ids.begin();
        fine.coarse_block.push_back(int(at));
        coarse.fine_block[std::size_t(at)] = b;
    }
}

} // namespace

Multigrid::Multigrid(const BlockTopology& topology, const MultigridOptions& options)
    : options_(options), weights_(chebyshev_weights(2.0, options.spectrum_ratio))
{
    BlockTopology level = topology;
    level.links = canonical_links(topology.links, link_source_);
    levels_.push_back(make_multigrid_level(level, options.shifted));
    while (cell_count(level) > options.coarsest_cells) {
        std::vector<CoarseLink> coarse_link;
        BlockTopology next = coarsened(level, coarse_link);
        if (cell_count(next) == cell_count(level)) break;
        levels_.back().mesh.coarse_link = std::move(coarse_link);
        levels_.push_back(make_multigrid_level(next, options.shifted));
        make_transfer(levels_.back());
        match_blocks(levels_[levels_.size() - 2], levels_.back());
        level = std::move(next);
    }
    coarsest_ = std::make_unique<CoarsestSolver>(levels_.back().mesh);
    list_steps();
}

Multigrid::~Multigrid() = default;
Multigrid::Multigrid(Multigrid&&) noexcept = default;

void Multigrid::list_steps()
{
    using K = MultigridStep::Kind;
    const int last = int(levels_.size()) - 1;
    for (int l = 0; l < last; ++l)
        set_up_.insert(set_up_.end(), {{K::prepare_level, l}, {K::end_resistances, l}, {K::coarsen, l}});
    set_up_.push_back({K::factorise, last});
    for (int l = 0; l < last; ++l)
        cycle_.insert(cycle_.end(), {{K::smooth_from_zero, l}, {K::smooth_second, l}, {K::residual, l},
                                     {K::gather_children, l}, {K::share_parts, l}});
    cycle_.push_back({K::coarsest, last});
    for (int l = last - 1; l >= 0; --l)
        cycle_.insert(cycle_.end(), {{K::prolong_up, l}, {K::smooth_first, l}, {K::smooth_second, l}});
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
    case K::prepare_level: return prepare_smoother(team, options_.smoother, level);
    case K::end_resistances: return link_end_resistances(team, level);
    case K::coarsen: coarsen_coefficients(team, level, coarse()); return coarsen_links(level, coarse());
    case K::factorise: return coarsest_->factorise(level, options_.singular);
    case K::smooth_from_zero: return smooth_from_zero(team, weights_, level);
    case K::smooth_first: return smooth_first(team, weights_, level);
    case K::smooth_second: return smooth_second(team, weights_, level);
    case K::residual: return compute_residual(team, level);
    case K::gather_children: return gather_children(team, level, coarse());
    case K::share_parts: return share_parts(team, coarse());
    case K::coarsest: return coarsest_->solve(level);
    case K::prolong_up: return prolong_correction(team, coarse(), level);
    }
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

void run_steps(const core::Team& team, Multigrid& multigrid, std::span<const MultigridStep> steps)
{
    for (const auto& step : steps) multigrid.run(team, step);
}

} // namespace physics
