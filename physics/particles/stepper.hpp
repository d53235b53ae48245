// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A batch of sub-steps on all ranks, cut into pieces of work with messages in between: whoever drives it may wait for the
// messages by holding a thread or by doing something else.
#include "core/particles/exchange.hpp"
#include "core/particles/ghosts.hpp"
#include "physics/particles/dynamics.hpp"

#include <functional>

namespace physics {

/// The rank that owns what lies at a position (relative to the domain's origin); the same answer on all ranks.
using OwnerOf = std::function<int(const core::Vec3& position)>;

/// Lives as long as the dynamics: it knows where the ghosts are.
///
///     stepper.begin(motion, sub_steps);
///     while (stepper.work(team)) { stepper.post(communicator, pending); wait for pending; }
class ParticleStepper {
public:
    /// @param ranks  Size of the communicator that will be used.
    ParticleStepper(ParticleDynamics& dynamics, OwnerOf owner_of, int rank, int ranks);
    /// For other particles on the same ranks.
    ParticleStepper(ParticleDynamics& dynamics, const ParticleStepper& like);

    /// Starts a batch of `sub_steps` sub-steps; no messages.
    /// @param time  At its beginning [s]; without it walls stand as at t = 0.
    void begin(const Motion& motion, int sub_steps, std::optional<double> time = {});
    /// Starts bringing every particle to the rank that owns the place where it lies, in a periodic domain back inside; no
    /// messages. Lists and ghosts are dropped. @pre the batch is finished
    void hand_over();
    /// Gives up what has been begun, and all lists: to be followed by setting particles and history anew.
    void give_up();
    /// Goes on to where messages of others are needed. @returns false when the batch or the handing over is finished.
    /// @throws core::NumericsError on all ranks alike if a particle has no finite speed.
    bool work(const core::Team& team);
    /// Sends and asks for what the next piece of work needs.
    void post(const core::Communicator& communicator, core::Pending& pending);

private:
    /// What the messages in flight are for.
    enum class Wait { speeds, displacement, extent, migrants, bin_lengths, bins, ghost_lengths, ghosts, leaver_lengths, leavers, nothing };

    void after_speeds(const core::Team& team);
    void start_rebuild(const core::Team& team);
    void pack_leavers();
    void take_arrivals();
    void sort_particles(const core::Team& team);
    void choose_ghosts();
    void sub_step(const core::Team& team);

    ParticleDynamics& dynamics_;
    OwnerOf owner_of_;
    int rank_, ranks_;
    core::Ghosts ghosts_;
    core::Exchange exchange_;
    Motion motion_;
    int sub_step_ = 0, sub_steps_ = 0;
    double time_ = 0.0; // that the fastest particle has gone since the last account
    Wait wait_ = Wait::nothing;
    bool have_ghosts_ = false, handing_over_ = false;
    std::array<double, 6 + core::radius_octaves> shared_; // greatest values of all ranks
    core::Octaves count_{};                               // particles of all ranks in each octave of radii; whole numbers, so exact
};

} // namespace physics
