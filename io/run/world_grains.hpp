// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a scene: their laws, their walls, their places at the start.
#include "core/grid/mesh.hpp"
#include "io/build/contact_builder.hpp"
#include "io/build/grain_census.hpp"
#include "physics/particles/stepper.hpp"

namespace io {

/// The dynamics without particles, with the sub-step that the contacts allow.
[[nodiscard]] physics::ParticleDynamics make_dynamics(const Scene& scene, const GrainCensus& census, const core::Mesh& mesh);

/// Adds those that lie where this rank owns. @pre no lists
void add_grains(const std::vector<core::Sphere>& grains, const physics::OwnerOf& owner_of, int rank, physics::ParticleDynamics& dynamics);

/// Gravity less buoyancy of the mean particle density: the weight under which a bed settles before the fluid is there [m/s2].
[[nodiscard]] core::Vec3 settling_gravity(const Scene& scene, const GrainCensus& census);

/// How stiff a bed of all grains is as a whole, per grain [N/m].
/// @param grains  Number of all ranks: an exact one, by which all ranks choose alike.
[[nodiscard]] double bed_stiffness(const BedContact& contact, const core::Vec3& gravity, const GrainCensus& census,
                                   const core::Domain& domain, double grains);

} // namespace io
