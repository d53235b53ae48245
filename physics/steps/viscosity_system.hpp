// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The equation of implicit viscosity, (1 - share dt nu Laplacian) change = share dt nu Laplacian w, for each component.
#include "physics/fluid/parameters.hpp"
#include "physics/fluid/krylov.hpp"
#include "physics/steps/unknown.hpp"

namespace physics {

class ViscositySystem {
public:
    /// @param layout  Of the flat vectors; must outlive the system. Collective.
    ViscositySystem(const SystemContext& context, const BlockLayout& layout, const FluidTolerances& tolerances);

    /// velocity += change, component by component.
    /// @param diffusion     share * dt * viscosity [m2].
    /// @param inflow        Net flux of the gradient of each component into each cell, with the walls' own velocities [m2/s].
    /// @param velocity      Provisional velocity in, implicit one out [m/s].
    tasks::Job solve(tasks::Lane& lane, double diffusion, const core::VectorField& inflow, core::VectorField& velocity);

    [[nodiscard]] int iterations() const { return iterations_; }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    SystemContext context_;
    FluidTolerances tolerances_;
    const BlockLayout& layout_;
    KrylovWorkspace workspace_;
    Unknown unknown_;
    core::ScalarField transmissibility_sum_;
    std::vector<double> right_, solution_, norms_;
    double diffusion_ = 0;
    int iterations_ = 0;
};

} // namespace physics
