// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The walls that the particles of a scene meet.
#include "core/grid/locate.hpp"
#include "core/particles/domain.hpp"
#include "io/build/wall_materials.hpp"
#include "io/scene/scene.hpp"
#include "physics/particles/dynamics.hpp"
#include "physics/particles/obstacles.hpp"

namespace io {

/// How a wall moves, with positions relative to `origin` [m].
[[nodiscard]] physics::WallMotion motion_of(const WallKeys& keys, const core::Vec3& origin);
/// The planes and cylinders of a scene's own walls, in their order, relative to `origin` [m].
[[nodiscard]] std::vector<physics::Wall> own_walls(const Scene& scene, const core::Vec3& origin);

/// All planes and cylinders that particles meet: those of the grid if the scene wants them, then its own.
[[nodiscard]] std::vector<physics::Wall> primitive_walls(const Scene& scene, const core::Domain& domain);
/// Adds the walls of triangles, and makes room for the loads of all walls of a scene's own, which are in the order of the scene.
/// @throws core::ConfigError for triangles that make no surface.
void add_own_surfaces(const Scene& scene, physics::ParticleDynamics& dynamics);
/// What particles keep clear of at the start: the same, and primitives where the faces of the grid lie.
[[nodiscard]] std::vector<physics::Wall> walls_at_start(const Scene& scene, const core::Domain& domain);
/// Walls and the surfaces of `dynamics`, where these are. @param dynamics  Lives as long.
[[nodiscard]] physics::Obstacles obstacles_of(const std::vector<physics::Wall>& walls, const physics::ParticleDynamics& dynamics);
/// The boundary of the mesh, continued through its periods by more than any particle reaches.
/// @param largest  Diameter of the largest particle [m].
[[nodiscard]] physics::WallSurface grid_surface(double largest, const core::Mesh& mesh, const core::Domain& domain,
                                                const WallMaterials& materials);

/// @throws core::ConfigError naming a particle that does not lie in cells of the grid as a whole.
void require_inside(const core::Locator& locator, const core::Domain& domain, const std::vector<core::Sphere>& grains);

/// @throws core::ConfigError for a particle that sticks in a wall of triangles at the start, or lies on its wrong side.
void require_clear_of_walls(const std::vector<WallKeys>& walls, const std::vector<core::Sphere>& grains,
                            const physics::ParticleDynamics& dynamics);

/// Walls that pass a good part of a particle in one sub-step would hit it with a force out of all proportion.
/// @param smallest  Diameter of the smallest particle [m]. @param step  Sub-step [s].
/// @throws core::ConfigError for such a wall.
void require_slow_walls(const std::vector<WallKeys>& walls, double smallest, const core::Domain& domain, double step);

} // namespace io
