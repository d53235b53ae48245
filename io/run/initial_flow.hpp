// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A known flow as the start of a world, for comparison with exact solutions.
#include "io/run/world.hpp"
#include <functional>

namespace io {

/// Velocity [m/s] at a position [m].
using VelocityFunction = std::function<core::Vec3(const core::Vec3&)>;

/// Sets velocity and fluxes from a flow without divergence. The flow counts as one that goes on, not as a jump.
/// Collective. @pre world.fluid(), world.compile()
void start_from(World& world, const VelocityFunction& velocity);

} // namespace io
