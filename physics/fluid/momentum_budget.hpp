// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the momentum of the fluid comes from and goes to in one step, per unit density.
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/diffusion.hpp"

namespace physics {

/// Sums over the cells of a block [m4/s].
struct MomentumBudget {
    core::Vec3 before = core::Vec3::Zero();  ///< at the start of the step
    core::Vec3 after = core::Vec3::Zero();   ///< at its end
    core::Vec3 through = core::Vec3::Zero(); ///< carried in and out through the boundaries
    /// What interpolation at departure points made or lost: zero in the exact equations. Of finite volumes, round-off.
    core::Vec3 advection = core::Vec3::Zero();
    core::Vec3 viscosity = core::Vec3::Zero(); ///< friction on walls, from the fluxes through them
    core::Vec3 pressure = core::Vec3::Zero();  ///< pressure on walls, from its values there
    core::Vec3 gradient = core::Vec3::Zero();  ///< sum of the gradients in the cells beyond that: zero on uniform grids
    core::Vec3 drive = core::Vec3::Zero();

    /// What no line explains: what the solver of the viscosity leaves.
    [[nodiscard]] core::Vec3 defect() const { return after - before - through - advection - viscosity - pressure - gradient - drive; }
    MomentumBudget& operator+=(const MomentumBudget& b)
    {
        before += b.before;
        after += b.after;
        through += b.through;
        advection += b.advection;
        viscosity += b.viscosity;
        pressure += b.pressure;
        gradient += b.gradient;
        drive += b.drive;
        return *this;
    }
};

/// Sum of volume * q over the cells of a block.
[[nodiscard]] core::Vec3 volume_sum(const core::BlockGeometry& geometry, core::VectorView<const double> q);

/// Flux of grad u, times factors, through the boundaries of a block into its cells; times density and viscosity, the friction on the
/// fluid [m2/s].
[[nodiscard]] core::Vec3 wall_friction(const core::BlockGeometry& geometry, const BlockWalls& walls,
                                       core::VectorView<const double> velocity, const FaceFactors& factors = {});

/// What the boundaries of a block push the fluid with, its pressure taken as that of the cells beside them where it is not given [N].
/// @param share  Of the given pressure that acts: 1 for the pressure, 0 for a change of it.
[[nodiscard]] core::Vec3 wall_push(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> pressure,
                                   double share);

/// Sum of flux * velocity through the boundaries of a block, inward; times dt, the momentum that flows in [m4/s2].
[[nodiscard]] core::Vec3 through_flow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<const double> flux,
                                      core::VectorView<const double> velocity);

} // namespace physics
