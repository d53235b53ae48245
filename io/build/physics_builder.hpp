// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what a scene says about matter to the parameters of physics.
#include "io/scene/scene.hpp"
#include "physics/fluid/k_epsilon.hpp"
#include "physics/fluid/parameters.hpp"
#include "physics/fluid/scalars.hpp"
#include "physics/particles/parameters.hpp"

namespace io {

/// @pre scene.fluid
[[nodiscard]] physics::FluidParameters fluid_parameters(const Scene& scene);

/// @pre scene.fluid
[[nodiscard]] std::vector<physics::ScalarParameters> scalar_parameters(const Scene& scene);

/// @pre scene.fluid->is_turbulent()
[[nodiscard]] physics::TurbulenceParameters turbulence_parameters(const Scene& scene);

/// @pre scene.contact. Gravity is that of the scene, without buoyancy.
[[nodiscard]] physics::ParticleParameters particle_parameters(const Scene& scene);

/// Acceleration of gravity [m/s2]; zero without it.
[[nodiscard]] core::Vec3 gravity_of(const Scene& scene);

} // namespace io
