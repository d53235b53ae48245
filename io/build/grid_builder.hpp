// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what a scene says about space to the mesh and to the box and walls of the particles.
#include "core/grid/mesh.hpp"
#include "core/particles/domain.hpp"
#include "io/build/wall_materials.hpp"
#include "io/scene/scene.hpp"
#include "physics/particles/walls.hpp"

namespace io {

/// The blocks of the scene's grid.
/// @throws core::ConfigError if they cannot be made.
[[nodiscard]] core::MultiBlock make_blocks(const Grid& grid);

/// Makes the grid and checks what its turn lays on each other.
/// @throws core::ConfigError naming the sides.
void require_turn_joins(const Grid& grid);

/// What the blocks fill. Along a periodic axis the box is one period long.
/// @throws core::ConfigError naming block and cell if a cell is folded or flat, or blocks lie in one another, or a side if it meets
///         several others.
[[nodiscard]] GridMeasure measured(const Grid& grid);

/// The box around the grid, with its periods.
[[nodiscard]] core::Domain make_domain(const Grid& grid);

/// The walls of a pipe or box as planes and cylinders, relative to the domain's origin.
[[nodiscard]] std::vector<physics::Wall> primitive_walls(const Grid& grid, const WallMaterials& materials);

/// Names of the boundaries, in the order of the alphabet.
[[nodiscard]] std::vector<std::string> boundary_names(const core::Topology& topology);

/// Names of the boundaries of the mesh that are walls for particles: all of them.
[[nodiscard]] std::vector<std::string> wall_names(const core::Mesh& mesh);

} // namespace io
