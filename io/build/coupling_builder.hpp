// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what a scene says of the coupling, or leaves to estimates, to the parameters of the physics.
#include "io/build/grain_census.hpp"
#include "io/scene/scene.hpp"
#include "physics/coupling/parameters.hpp"
#include "physics/particles/parameters.hpp"

namespace io {

/// @pre scene.fluid and particles
[[nodiscard]] physics::CouplingParameters coupling_parameters(const Scene& scene, const GrainCensus& census);

/// The films that a scene asks for; none without.
[[nodiscard]] physics::LubricationFilm lubrication_film(const Scene& scene, const GrainCensus& census);

/// Does the fluid of a scene not feel its particles?
[[nodiscard]] bool is_one_way(const Scene& scene);

/// The mode of coupling that the scene insists on; none for `auto`. @throws core::ConfigError for one that no step has.
[[nodiscard]] std::optional<physics::Mode> asked_mode(const Scene& scene);

} // namespace io
