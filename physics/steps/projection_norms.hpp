// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How exactly the equation of a projection is to be solved, from the fluxes that it projects.
#include "core/grid/mesh.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/krylov.hpp"
#include "physics/fluid/parameters.hpp"
#include "tasks/lane.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace physics {

class ProjectionNorms {
public:
    /// @param singular  Is the pressure known up to a constant?
    ProjectionNorms(const core::Mesh& mesh, const FluidTolerances& tolerances, bool singular)
        : mesh_(mesh), tolerances_(tolerances), singular_(singular), sums_(2 * std::size_t(mesh.blocks()))
    {
    }

    /// Sums up over all ranks; the bits do not depend on their number.
    /// @param outflow     Net outflow of the fluxes to project [m3/s].
    /// @param throughput  Half the sum of the magnitudes of the fluxes of each cell [m3/s]: what the tolerance refers to.
    tasks::Job gather(tasks::Lane& lane, const core::ScalarField& outflow, const core::ScalarField& throughput)
    {
        std::fill(sums_.begin(), sums_.end(), 0.0);
        lane.team().run(mesh_.own_count(), [&](int b) {
            const auto square = [](double x) { return x * x; };
            const auto global = std::size_t(mesh_.global(b));
            sums_[global] = sum_cells(square, throughput.on(b));
            sums_[std::size_t(mesh_.blocks()) + global] = sum_cells(square, outflow.on(b));
        });
        co_await lane.sum(sums_);
        const auto half = sums_.begin() + mesh_.blocks();
        through_ = std::sqrt(std::accumulate(sums_.begin(), half, 0.0));
        out_ = std::sqrt(std::accumulate(half, sums_.end(), 0.0));
    }

    /// 2-norm of the net outflow [m3/s].
    [[nodiscard]] double outflow() const { return out_; }
    /// @param share  Of the tolerance that the step may use up.
    [[nodiscard]] KrylovOptions options(double share) const
    {
        KrylovOptions options;
        options.relative = 1e-13; // round-off: the tolerance proper is absolute
        options.absolute = tolerances_.pressure_target(through_, out_, share);
        options.most_iterations = tolerances_.most_iterations;
        options.singular = singular_;
        options.from_zero = true;
        // Fluxes cancel to round-off of themselves, however small what is left of them.
        options.largest_defect = std::max(options.largest_defect, out_ > 0 ? 1e-12 * through_ / out_ : 0.0);
        return options;
    }

private:
    const core::Mesh& mesh_;
    FluidTolerances tolerances_;
    bool singular_;
    std::vector<double> sums_;
    double through_ = 0, out_ = 0;
};

} // namespace physics
