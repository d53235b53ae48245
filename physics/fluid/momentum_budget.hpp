// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the momentum of the fluid comes from and goes to in one step, per unit density.
#include "core/grid/geometry.hpp"

namespace physics {

/// Sums over the cells of a block [m4/s].
struct MomentumBudget {
    core::Vec3 before = core::Vec3::Zero();    ///< at the start of the step
    core::Vec3 after = core::Vec3::Zero();     ///< at its end
    core::Vec3 advection = core::Vec3::Zero(); ///< what interpolation at departure points made or lost: zero in the exact equations
    core::Vec3 viscosity = core::Vec3::Zero(); ///< friction on walls
    core::Vec3 pressure = core::Vec3::Zero();  ///< pressure on walls
    core::Vec3 drive = core::Vec3::Zero();

    /// What no line explains: round-off.
    [[nodiscard]] core::Vec3 defect() const { return after - before - advection - viscosity - pressure - drive; }
    MomentumBudget& operator+=(const MomentumBudget& b)
    {
        before += b.before;
        after += b.after;
        advection += b.advection;
        viscosity += b.viscosity;
        pressure += b.pressure;
        drive += b.drive;
        return *this;
    }
};

/// Sum of volume * q over the cells of a block.
[[nodiscard]] core::Vec3 volume_sum(const core::BlockGeometry& geometry, core::VectorView<const double> q);

} // namespace physics
