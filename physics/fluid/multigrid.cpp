// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid.hpp"

#include "core/base/error.hpp"
#include "physics/fluid/multigrid_coarsen.hpp"
#include <algorithm>
#include <cmath>

namespace physics {
namespace {

/// Is the coefficient of one of some faces in a row much larger than that of its neighbour `stride` further on? Zeros do not count.
bool differ(const SevenPoint<double>& a, std::ptrdiff_t begin, int faces, std::ptrdiff_t stride)
{
    int sharp = 0;
    for (const auto& face : a.face) {
        const double *here = face.data() + begin, *next = here + stride;
#pragma omp simd reduction(+ : sharp)
        for (int n = 0; n < faces; ++n) {
            const double least = std::min(here[n], next[n]), most = std::max(here[n], next[n]);
            sharp += int(least > 0.0) & int(most > CoefficientRange::sharp * least);
        }
    }
    return sharp > 0;
}

} // namespace

Multigrid::Multigrid(const BlockTopology& topology, const MultigridOptions& options, const core::Communicator& communicator)
    : options_(options),
      weights_(chebyshev_weights(2.0, options.spectrum_ratio)),
      firm_weights_(weights_for_firm_lines()),
      aggregates_(topology.owner, options.coarsest_cells)
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
    list_aggregates();
}

Multigrid::Multigrid(const Multigrid& other, WithShift)
    : options_(other.options_),
      weights_(other.weights_),
      firm_weights_(other.firm_weights_),
      link_source_(other.link_source_),
      levels_(other.levels_),
      coarsest_(std::make_unique<CoarsestSolver>(levels_.back().mesh)),
      aggregates_(other.aggregates_.like()),
      has_grids_(other.has_grids_),
      set_up_(other.set_up_),
      cycle_(other.cycle_),
      aggregate_set_up_(other.aggregate_set_up_),
      aggregate_cycle_(other.aggregate_cycle_)
{
    options_.shifted = true;
    options_.singular = false;
    for (MultigridLevel& level : levels_) level.matrix.shift.assign(level.mesh.layout.size(), 0.0F);
    keep_grids();
}

Multigrid::~Multigrid() = default;
Multigrid::Multigrid(Multigrid&&) noexcept = default;

void Multigrid::keep_grids()
{
    if (has_grids_ != by_coefficients_) return;
    has_grids_ = !by_coefficients_;
    for (std::size_t l = 1; l < levels_.size(); ++l)
        if (has_grids_) restore(options_.shifted, levels_[l]);
        else release(levels_[l]);
}

void Multigrid::load(const core::Team& team, const SevenPoint<double>& fine, const CoefficientRange& range)
{
    by_coefficients_ =
        options_.coarsening == Coarsening::coefficients || (options_.coarsening == Coarsening::automatic && range.jumps > 0.0);
    keep_grids();
    const double scale = power_of_two_scale(range.largest);
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

std::size_t Multigrid::bytes() const
{
    std::size_t sum = 0;
    for (const auto& l : levels_) sum += l.bytes();
    return sum + aggregates_.bytes();
}

CoefficientRange coefficient_range(const LevelMesh& mesh, const SevenPoint<double>& a)
{
    CoefficientRange range;
    for (const auto& p : mesh.layout.pieces()) {
        const auto cells = mesh.layout.cells(p.block);
        const int rows = cells.nj * cells.nk;
        for (const auto& face : a.face)
            for (auto c = std::size_t(p.begin); c < std::size_t(p.end); ++c) range.largest = std::max(range.largest, face[c]);
        for (int row = p.first(rows); row < p.last(rows) && range.jumps == 0.0; ++row) {
            const auto begin = mesh.layout.origin(p.block) + std::ptrdiff_t(row) * cells.ni;
            const bool jumps = differ(a, begin, cells.ni - 1, 1) ||
                               (row % cells.nj + 1 < cells.nj && differ(a, begin, cells.ni, cells.ni)) ||
                               (row / cells.nj + 1 < cells.nk && differ(a, begin, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj));
            if (jumps) range.jumps = 1.0;
        }
    }
    for (const double s : a.shift) range.largest = std::max(range.largest, s);
    for (const double l : a.link) range.largest = std::max(range.largest, l);
    return range;
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
