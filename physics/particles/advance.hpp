// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Batches of sub-steps without a task graph: settling, tests, benchmarks.
#include "physics/particles/stepper.hpp"

namespace physics {

/// Drives what has been begun to its end, waiting for messages.
inline void drive(ParticleStepper& stepper, const core::Team& team, const core::Communicator& communicator)
{
    while (stepper.work(team)) {
        core::Pending pending;
        stepper.post(communicator, pending);
        pending.wait();
    }
}

/// Runs `sub_steps` sub-steps of all particles and waits for them. The communicator must have messages of its own.
/// @param time  At their beginning [s]; without it walls stand as at t = 0.
inline void settle(ParticleStepper& stepper, const Motion& motion, int sub_steps, const core::Team& team,
                   const core::Communicator& communicator, std::optional<double> time = {})
{
    stepper.begin(motion, sub_steps, time);
    drive(stepper, team, communicator);
}

/// Brings every particle to the rank that owns the place where it lies.
inline void hand_over(ParticleStepper& stepper, const core::Team& team, const core::Communicator& communicator)
{
    stepper.hand_over();
    drive(stepper, team, communicator);
}

/// The same on one rank.
inline void settle(ParticleDynamics& dynamics, const Motion& motion, int sub_steps, const core::Team& team, std::optional<double> time = {})
{
    ParticleStepper stepper(dynamics, {}, 0, 1);
    settle(stepper, motion, sub_steps, team, core::Communicator::self(), time);
}

} // namespace physics
