// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a flux of the fluid lacks, beside grains, to fill the share of each cell that they leave: the flux of a potential, so small
// as it can be. Fluxes and places of grains are each right to second order only, and what is carried would have to be made or lost
// where they disagree.
#include "physics/steps/fluid_step.hpp"

namespace physics {

class FluxAgreement {
public:
    /// Allocates; the fluid must outlive it. Collective.
    FluxAgreement(const core::Mesh& mesh, const FluidStep& fluid, const core::Communicator& ranks);

    /// Flux of the fluid over a step, and the shares of the cells that it fills before and after.
    struct Change {
        const core::FaceField& flux; ///< [m3/s]
        const core::ScalarField &before, &after;
        double dt; ///< [s]
    };
    /// Finds the potential of what `change` lacks.
    tasks::Job solve(tasks::Lane& lane, Change change);
    /// Adds its flux: to that of the change, V (after - before) = - dt sum F to the tolerance of the pressure.
    void add(core::LocalBlock b, core::FaceView<double> flux);

private:
    const core::Mesh& mesh_;
    SystemContext context_;
    PressureSystem system_;
    core::ScalarField outflow_, through_, psi_;
    core::VectorField gradient_;
    core::FaceField scratch_;
};

} // namespace physics
