// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a scene at the start: placed, or from files.
#include "core/comm/communicator.hpp"
#include "core/particles/particle_set.hpp"
#include "io/scene/scene.hpp"
#include "physics/particles/dynamics.hpp"

namespace io {

/// The particles of all species that are in files; positions relative to the domain's origin, the same on all ranks. Collective.
/// @throws core::ConfigError if a file has other than what the scene says.
[[nodiscard]] std::vector<core::Sphere> grains_of_files(const Scene& scene, const core::Domain& domain, const core::Communicator& ranks);

/// All particles of all species, ids in their order; those that are placed keep clear of all walls.
/// @param dynamics  With all walls.
/// @throws core::ConfigError if they find no room.
[[nodiscard]] std::vector<core::Sphere> initial_grains(const Scene& scene, const std::vector<core::Sphere>& of_files,
                                                       const physics::ParticleDynamics& dynamics);

} // namespace io
