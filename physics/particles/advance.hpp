// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Batches of sub-steps without a task graph: settling, tests, benchmarks.
#include "core/comm/communicator.hpp"
#include "physics/particles/dynamics.hpp"

namespace physics {

/// Runs `sub_steps` sub-steps of all particles.
void settle(ParticleDynamics& dynamics, const Motion& motion, int sub_steps, const core::Team& team,
            const core::Communicator& communicator);

} // namespace physics
