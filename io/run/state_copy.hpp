// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The state of a world in memory, so that a step that failed leaves no trace.
#include "core/particles/contact_history.hpp"
#include "core/particles/particle_set.hpp"
#include "io/run/grain_traffic.hpp"
#include "physics/fluid/state.hpp"

namespace io {

class World;

class StateCopy {
public:
    /// Takes the state of this rank, between steps. Memory is kept from one copy to the next.
    void take(World& world);
    /// Puts it back. @pre no lists of grains that touch are in use. What is derived from the state is not restored.
    void put_back(World& world) const;
    /// Of this rank, as they were.
    [[nodiscard]] const core::ParticleSet& particles() const { return particles_; }

private:
    std::vector<std::vector<double>> arrays_; ///< of all carried fields, block after block, halos included
    physics::FluidClock clock_;
    core::ParticleSet particles_;
    core::ContactHistory history_;
    GrainTraffic::State traffic_;
};

} // namespace io
