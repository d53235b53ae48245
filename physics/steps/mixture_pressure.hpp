// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The equation of the projection with grains: div(mobility grad dp) = div(flux), the mobility a field of this step.
#include "physics/fluid/mobility.hpp"
#include "physics/fluid/seven_point_solver.hpp"
#include "physics/steps/projection_norms.hpp"
#include "physics/steps/unknown.hpp"

namespace physics {

class MixturePressure {
public:
    /// Collective.
    MixturePressure(const SystemContext& context, const core::Communicator& ranks, const FluidTolerances& tolerances);

    /// Solves for dp so that (flux - mobility * compact flux of grad dp) has no net outflow.
    /// @param mobility    On faces [m3 s/kg].
    /// @param share       Of the tolerance that this step may use up: below 1 for steps shorter than those before.
    /// @param outflow     Net outflow of the predicted flux [m3/s]; must sum to zero.
    /// @param throughput  Half the sum of the magnitudes of the fluxes of each cell [m3/s]: what the tolerance refers to.
    /// @param[out] change Interior [Pa].
    tasks::Job solve(tasks::Lane& lane, double share, const core::FaceField& mobility, const core::ScalarField& outflow,
                     const core::ScalarField& throughput, core::ScalarField& change);

    [[nodiscard]] const KrylovReport& report() const { return report_; }
    [[nodiscard]] const BlockLayout& layout() const { return solver_.layout(); }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    tasks::Job load(tasks::Lane& lane);

    SystemContext context_;
    MeshLinks links_;
    std::vector<LinkFace> link_faces_;
    SevenPointSolver solver_;
    Unknown unknown_;
    core::FaceField coefficients_;
    const core::FaceField* mobility_ = nullptr; ///< of the solve that is on its way
    std::vector<double> link_coefficients_, right_, solution_;
    ProjectionNorms norms_;
    KrylovReport report_;
};

} // namespace physics
