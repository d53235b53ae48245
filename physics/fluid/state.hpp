// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The state of the fluid: all that the next step reads of the last one.
#include "core/grid/mesh.hpp"
#include "physics/fluid/drive.hpp"
#include <algorithm>
#include <cstdint>

namespace physics {

/// Time, step sizes and the state of the drive.
struct FluidClock {
    double time = 0;        ///< of the velocity [s]
    double dt = 0;          ///< of the step that is being made, set before it [s]
    double dt_before = 0;   ///< of the last step; 0 before the first [s]
    double memory_time = 0; ///< that faces remember fluxes for: the longest of the recent steps [s]
    std::int64_t step = 0;
    /// Steps made since the forcing jumped. After a jump two steps treat viscosity fully implicitly, so that nothing rings.
    /// @source  Rannacher (1984): four half steps or two full ones before Crank-Nicolson.
    int steps_since_jump = 0;
    DriveState drive;

    /// Weight of the new time in the viscous term.
    [[nodiscard]] double implicit_share() const { return steps_since_jump < 2 ? 1.0 : 0.5; }
    /// Weight of (velocity - velocity before) for the velocity at the middle of the step, at most 1.
    [[nodiscard]] double extrapolation() const
    {
        return dt_before > 0 && dt < 2 * dt_before ? 0.5 * dt / dt_before : dt_before > 0 ? 1.0 : 0.0;
    }
    /// Share of what faces remember that outlives the step: none unless steps were longer a while ago (see flux_memory.hpp).
    [[nodiscard]] double memory() const { return dt < memory_time ? 1.0 - dt / memory_time : 0.0; }
    /// The step has been made.
    void advance()
    {
        time += dt;
        dt_before = dt;
        constexpr double adaption = 0.25; // after four times its length a long step is forgotten
        memory_time = std::max(dt, memory_time - adaption * dt);
        ++step;
        ++steps_since_jump;
    }
};

/// Fields of the fluid that are carried from step to step.
struct FluidState {
    explicit FluidState(const core::Mesh& mesh)
        : velocity({"velocity", "m/s", 3, true, true}, mesh.own_cells()),
          velocity_before({"velocity before", "m/s", 1, true}, mesh.own_cells()),
          pressure({"pressure", "Pa", 1, true}, mesh.own_cells()),
          flux({"volume flux", "m3/s", 0, true}, mesh.own_cells()),
          flux_before({"volume flux before", "m3/s", 0, true}, mesh.own_cells())
    {
    }

    core::VectorField velocity;
    core::VectorField velocity_before; ///< at the last time: for the velocity of trajectories
    core::ScalarField pressure;        ///< dynamic, without the drive, at the middle of the last step
    core::FaceField flux;              ///< through faces, free of divergence to the solver's tolerance
    core::FaceField flux_before;       ///< at the last time: for that in the middle of a step; advection by finite volumes alone has it
    FluidClock clock;
};

} // namespace physics
