// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Particles that change their rank, with all their columns and the springs of their contacts.
#include "core/particles/contact_history.hpp"
#include "core/particles/particle_set.hpp"

#include <cstddef>

namespace core {

/// Appends owned particle i and its row of `history` to `bytes`.
void pack_particle(const ParticleSet& particles, const ContactHistory& history, int i, std::vector<std::byte>& bytes);

/// Appends all particles in `bytes` to the owned ones and their rows to `history`. @pre no ghosts; all histories equally wide
void unpack_particles(std::span<const std::byte> bytes, ParticleSet& particles, ContactHistory& history);

} // namespace core
