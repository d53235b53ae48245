// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The equation of the projection: div(grad psi) = div(flux), psi = mobility * pressure increment, with the full operator.
#include "physics/fluid/seven_point_solver.hpp"
#include "physics/steps/projection_norms.hpp"
#include "physics/steps/unknown.hpp"

namespace physics {

class PressureSystem {
public:
    /// Sets up the multigrid. Collective.
    PressureSystem(const SystemContext& context, const core::Communicator& ranks, const FluidTolerances& tolerances);

    /// Solves for psi so that (flux - compact flux of grad psi) has no net outflow.
    /// @param share       Of the tolerance that this step may use up: below 1 for steps shorter than those before.
    /// @param outflow     Net outflow of the predicted flux [m3/s]; must sum to zero.
    /// @param throughput  Half the sum of the magnitudes of the fluxes of each cell [m3/s]: what the tolerance refers to.
    /// @param[out] psi    Interior [m2/s].
    tasks::Job solve(tasks::Lane& lane, double share, const core::ScalarField& outflow, const core::ScalarField& throughput,
                     core::ScalarField& psi);

    [[nodiscard]] const KrylovReport& report() const { return report_; }
    [[nodiscard]] const BlockLayout& layout() const { return solver_.layout(); }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    SystemContext context_;
    SevenPointSolver solver_;
    Unknown unknown_;
    std::vector<double> right_, solution_;
    ProjectionNorms norms_;
    KrylovReport report_;
};

} // namespace physics
