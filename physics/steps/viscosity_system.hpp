// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The equation of implicit viscosity, u = w + share dt nu Laplacian u, for all components of a velocity.
#include "physics/fluid/krylov.hpp"
#include "physics/fluid/parameters.hpp"
#include "physics/steps/diffusion_multigrid.hpp"
#include "physics/steps/joined_components.hpp"

namespace physics {

class ViscositySystem {
public:
    /// @param pressure  Whose flat vectors and grids are used; must outlive the system. Collective.
    ViscositySystem(const SystemContext& context, const PressureSystem& pressure, const FluidTolerances& tolerances);

    /// Jacobi's iteration, which suffices where little diffuses from cell to cell in a step; where it is slow, BiCGSTAB goes on, with
    /// V-cycles where viscosity is stiff.
    /// @param diffusion  share * dt * viscosity [m2].
    /// @param velocity   w in, u out [m/s].
    /// @param change     First guess of u - w in, u - w out [m/s].
    tasks::Job solve(tasks::Lane& lane, double diffusion, core::VectorField& velocity, core::VectorField& change);

    /// Of the last solve: products with the operator.
    [[nodiscard]] int iterations() const { return iterations_; }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    /// 2-norms over all cells and components [m4/s]: of the residual, of the viscous change, of the momentum per density.
    struct Norms {
        double residual, change, momentum;
    };
    tasks::Job form_residual(tasks::Lane& lane, const core::VectorField& change, core::VectorField& velocity, Norms& norms);
    void correct(tasks::Lane& lane, core::VectorField& velocity, core::VectorField& change) const;
    tasks::Job solve_joined(tasks::Lane& lane, KrylovOptions options, core::VectorField& velocity, core::VectorField& change);
    tasks::Job solve_component(tasks::Lane& lane, int component, const KrylovOptions& options, core::VectorField& velocity,
                               core::VectorField& change);

    tasks::Job choose_preconditioner(tasks::Lane& lane);
    void add_given_values(core::LocalBlock b, core::FaceView<const double> factor, core::View<double> shift) const;

    SystemContext context_;
    FluidTolerances tolerances_;
    const BlockLayout& layout_;
    KrylovWorkspace workspace_;
    Unknown unknown_;
    core::ScalarField transmissibility_sum_, reciprocal_; ///< the latter of the diagonal of the equation being solved
    core::VectorField residual_;
    core::TensorField gradient_; ///< of the components
    core::FaceField flux_;
    std::vector<double> right_, solution_, sums_;
    DiffusionMultigrid multigrid_;
    std::unique_ptr<JoinedComponents> joined_; ///< none unless seams turn
    bool by_multigrid_ = false;                ///< the equation that is being solved
    double diffusion_ = 0;
    int component_ = 0; ///< that is being solved for
    int iterations_ = 0;
};

} // namespace physics
