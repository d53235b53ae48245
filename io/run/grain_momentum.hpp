// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The momentum of all grains in a fluid, and what gave it to them in the last step.
#include "io/run/world.hpp"

namespace io {

struct GrainMomentum {
    core::Vec3 momentum = core::Vec3::Zero(); ///< [N s]
    core::Vec3 owed = core::Vec3::Zero();     ///< by the fluid [N s]
    core::Vec3 contact = core::Vec3::Zero();  ///< impulse of walls: pairs cancel [N s]
    core::Vec3 taken = core::Vec3::Zero();    ///< impulse of all but contact, weight and drive, and what is owed [N s]
    core::Vec3 couple = core::Vec3::Zero();   ///< angular impulse of the fluid's torque [N m s]
    double buoyant_mass = 0.0;                ///< less that of the fluid displaced [kg]
    double volume = 0.0;                      ///< [m3]
};

/// Exact sums over the grains of all ranks. Collective. @pre world.exchange()
/// @param drive  Acceleration of the drive that the grains were told [m/s2].
[[nodiscard]] GrainMomentum grain_momentum(const World& world, const core::Vec3& drive);

} // namespace io
