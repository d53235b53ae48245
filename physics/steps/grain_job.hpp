// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sub-steps of grains as a job of a stage, which holds no thread while messages are on their way.
#include "physics/particles/stepper.hpp"
#include "tasks/lane.hpp"

namespace physics {

/// Drives what has been begun to its end.
[[nodiscard]] inline tasks::Job drive(tasks::Lane& lane, ParticleStepper& stepper)
{
    while (stepper.work(lane.team())) {
        core::Pending pending;
        {
            const auto mpi = lane.messages();
            stepper.post(lane.communicator(), pending);
        }
        co_await lane.arrive(pending);
    }
}

/// Sub-steps, after which every grain is on the rank that owns the place where it lies and no list is left: what follows,
/// and a checkpoint, finds the same state whether or not the run has been interrupted.
/// @param time  At their beginning [s].
[[nodiscard]] inline tasks::Job move_grains(tasks::Lane& lane, ParticleStepper& stepper, Motion motion, int sub_steps, double time)
{
    stepper.begin(motion, sub_steps, time);
    co_await drive(lane, stepper);
    stepper.hand_over();
    co_await drive(lane, stepper);
}

} // namespace physics
