// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fluid lane takes the grains for where it does not wait for them: the modes `coarse` and `concurrent` of response.hpp.
#include "physics/particles/newton.hpp"

namespace physics {

/// Sub-steps of the grains in one sub-step of the coarse pass.
inline constexpr int coarsening = 3;

/// Makes loads for one sub-step loads for a sub-step `factor` times as long: exact for constant contact forces.
void stretch_loads(core::ParticleSet& grains, const WetColumns& wet, double factor);

/// Free flight over all sub-steps, held back by the hold of each grain; the impulse of the contacts that do so is recorded.
/// Places stay.
/// @param hold  Column, 0 to 1.   @param dt  Of all sub-steps [s].
void fly(core::ParticleSet& grains, const WetColumns& wet, int hold, double dt, int sub_steps);

} // namespace physics
