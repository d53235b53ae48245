// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the linear solvers need of the mesh: links between the sides of blocks with their two-point transmissibilities.
#include "core/grid/mesh.hpp"
#include "physics/fluid/block_topology.hpp"
#include <functional>

namespace physics {

struct MeshLinks {
    BlockTopology topology;
    std::vector<double> transmissibility; ///< of each link, |S|^2 / (S . d): goes with cross terms [m]
    std::vector<double> spreading;        ///< of each link, (S . d) / |d|^2: see spreading() [m]
    /// Of each link that is a sub-face, its number in BlockGeometry::sub_faces: of block a if that is on this rank, else of b. Else -1.
    std::vector<int> sub_face;
};

/// Links of all sides that touch a block of this rank. Each transmissibility comes from the vertices of the same block on
/// every rank, so that its bits do not depend on the number of ranks.
/// @param gives_value  Is the unknown given on this boundary? Asked for those of this rank; elsewhere nothing flows.
[[nodiscard]] MeshLinks make_mesh_links(
    const core::Mesh& mesh, int rank,
    const std::function<bool(const core::Boundary&)>& gives_value = [](const core::Boundary&) { return false; });

/// Two-point transmissibilities (S . d) / |d|^2 of the faces, for diffusion without cross terms: on skewed cells, too, it
/// spreads a quantity over the right mean square distance, that is with the right trace of its second moment.
/// @param[out] out  [m]
void spreading(const core::BlockGeometry& geometry, core::FaceView<double> out);

} // namespace physics
