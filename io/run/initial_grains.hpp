// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a scene at the start: placed, or from files.
#include "core/comm/communicator.hpp"
#include "core/particles/particle_set.hpp"
#include "io/scene/scene.hpp"

namespace io {

/// All particles of all species, ids in their order; positions relative to the domain's origin, the same on all ranks. Collective.
/// @throws core::ConfigError if they find no room, or a file has other than what the scene says.
[[nodiscard]] std::vector<core::Sphere> initial_grains(const Scene& scene, const core::Domain& domain, const core::Communicator& ranks);

} // namespace io
