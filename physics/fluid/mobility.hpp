// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mobility that varies from cell to cell, on faces: how much volume flux a pressure gradient makes there.
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/mesh_links.hpp"

namespace physics {

/// Harmonic mean of the two cells of each face: where grains block one of them, little goes through. Bits do not depend on
/// the side from which a face is seen.
/// @param mobility  One halo layer, mirrored evenly beyond walls.
void face_mobility(const core::BlockGeometry& geometry, core::View<const double> mobility, core::FaceView<double> faces);

/// flux *= mobility on every face.
void scale_by_mobility(const core::BlockGeometry& geometry, core::FaceView<const double> mobility, core::FaceView<double> flux);

/// Transmissibility of every face [m].
void transmissibility(const core::BlockGeometry& geometry, core::FaceView<double> out);

/// Where the face of each link lies in the fields of this rank; sub-faces along their fourth axis.
struct LinkFace {
    core::LocalBlock block;
    int axis;
    core::Index3 face;
};
/// @pre Every link touches a block of this rank.
[[nodiscard]] std::vector<LinkFace> link_faces(const core::Mesh& mesh, const MeshLinks& links);

} // namespace physics
