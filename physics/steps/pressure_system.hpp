// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The equation of the projection with the full operator, which on straight meshes is that of seven points:
// div(grad psi) = div(flux), psi = mobility * pressure increment; or, with grains, div(mobility grad dp) = div(flux), the
// mobility a field of this step.
#include "physics/fluid/mobility.hpp"
#include "physics/fluid/seven_point_solver.hpp"
#include "physics/steps/projection_norms.hpp"
#include "physics/steps/unknown.hpp"

namespace physics {

/// The fluxes that a projection is to make free of divergence.
struct FluxesToProject {
    const core::ScalarField& outflow;    ///< net outflow of each cell; must sum to zero [m3/s]
    const core::ScalarField& throughput; ///< half the sum of the magnitudes of a cell's fluxes: what the tolerance refers to [m3/s]
    double share = 1.0;                  ///< of the tolerance that this step may use up: below 1 for steps shorter than those before
};

class PressureSystem {
public:
    /// Collective.
    PressureSystem(const SystemContext& context, const core::Communicator& ranks, const FluidTolerances& tolerances);

    /// Solves for psi so that (flux - compact flux of grad psi) has no net outflow.
    /// @param[out] psi  Interior [m2/s].
    tasks::Job solve(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi);
    /// Solves for dp so that (flux - mobility * compact flux of grad dp) has no net outflow.
    /// @param mobility     On faces [m3 s/kg].
    /// @param[out] change  Interior [Pa].
    tasks::Job solve(tasks::Lane& lane, const core::FaceField& mobility, FluxesToProject fluxes, core::ScalarField& change);

    /// The same for further fluxes of the step, with the mobility of the last solve; their iterations add to those in its report.
    tasks::Job solve_again(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi);
    /// flux -= mobility * compact flux of grad psi, with the mobility of the last solve.
    tasks::Job take_off(tasks::Lane& lane, const core::ScalarField& psi, core::FaceField& flux);

    [[nodiscard]] const KrylovReport& report() const { return report_; }
    [[nodiscard]] const BlockLayout& layout() const { return solver_.layout(); }
    /// Grids and links, for other equations on the same mesh.
    [[nodiscard]] const SevenPointSolver& solver() const { return solver_; }
    [[nodiscard]] const MeshLinks& links() const { return links_; }
    [[nodiscard]] std::span<const LinkFace> link_faces() const { return link_faces_; }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    tasks::Job load(tasks::Lane& lane);
    tasks::Job solve_loaded(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi);

    SystemContext context_;
    MeshLinks links_;
    std::vector<LinkFace> link_faces_;
    SevenPointSolver solver_;
    Unknown unknown_;
    core::FaceField coefficients_;
    const core::FaceField* mobility_ = nullptr; ///< of the solve that is on its way; none: 1 everywhere
    bool loaded_ = false;                       ///< the solver holds the coefficients without mobility
    std::vector<double> link_coefficients_, right_, solution_;
    ProjectionNorms norms_;
    KrylovReport report_;
};

} // namespace physics
