// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Copies of other ranks' particles that this rank's particles may touch: who needs whom, and their motion in each sub-step.
#include "core/comm/communicator.hpp"
#include "core/particles/level_bins.hpp"
#include "core/particles/particle_set.hpp"

namespace core {

/// The bins where a particle must lie to touch an owned particle of this rank: the occupied bins and all around them, periodic images
/// included; for each level those around its owned particles, where all that are not larger may touch them, and those around smaller
/// ones, where only particles of the level may. Marks of such bins in rising order.
[[nodiscard]] std::vector<std::int64_t> bins_of_interest(const ParticleSet& particles, const LevelBins& bins);

/// Ghosts keep the position of their owner; the lists know the image through which they are seen.
class Ghosts {
public:
    /// Chooses the owned particles that rank r needs. @param wanted  wanted[r]: the bins of interest of rank r, rising.
    void choose(const ParticleSet& particles, const LevelBins& bins, const std::vector<std::vector<std::int64_t>>& wanted);
    /// What rank r must know of its ghosts once.
    [[nodiscard]] std::vector<std::byte> describe(const ParticleSet& particles, int rank) const;
    /// Adds the ghosts that the other ranks describe behind the owned particles.
    void adopt(const std::vector<std::vector<std::byte>>& descriptions, ParticleSet& particles);

    /// Sends positions, velocities and spins of this rank's particles to those who hold ghosts of them.
    void post_motion(const ParticleSet& particles, const Communicator& communicator, Pending& pending);
    /// Takes over what post_motion() has received, when it is there.
    void take_motion(ParticleSet& particles) const;

private:
    std::vector<std::vector<int>> chosen_; // owned particles for each rank
    std::vector<int> count_;               // ghosts from each rank
    std::vector<std::vector<double>> out_, in_;
};

} // namespace core
