// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Two sides of blocks that meet without matching points: their faces intersected to sub-faces (NUMERICS B8), each with one
// area vector for the two cells that it joins.
//
// The first side is the master: its edges stay straight, and every point of the intersection on one of them lies exactly on
// it. So the sub-faces of each of its faces add up to the face. The edges of the other side bend to these points; what they
// sweep is a sliver, an area vector that the face between two neighbours of that side takes up, so that all cells close.
#include "core/grid/side_tiling.hpp"

namespace core {

/// A piece of a face of either side.
struct SubFace {
    FaceIndex master, other;
    Vec3 area;   ///< in the direction of the master's area vectors [m2]
    Vec3 centre; ///< [m]
};

/// A point through which an edge of the other side bends.
struct EdgePoint {
    int axis = 0;     ///< 0: the edge from vertex (p, q) to (p + 1, q); 1: to (p, q + 1)
    FaceIndex vertex; ///< where the edge starts
    double share = 0; ///< of the edge, where it crosses an edge of the master
    Vec3 point;       ///< on that edge [m]
};

/// An area vector that one face of the other side has ceded to its neighbour across an edge.
struct CededArea {
    int axis = 0; ///< of the edge, as in EdgePoint
    FaceIndex vertex;
    Vec3 area; ///< as the edge sweeps it [m2]
};

struct SideOverlap {
    std::vector<SubFace> faces; ///< ordered by master, then other
    std::vector<EdgePoint> points;
    std::vector<CededArea> ceded; ///< by merged slivers
    std::vector<Vec3> rim;        ///< vertices at the rim of the master [m]
    bool same_sense = true;       ///< The area vectors of the two sides point the same way.
};

struct OverlapTolerance {
    double gap = 0.15;    ///< largest distance of the surfaces, over the size of a face
    double snap = 1e-7;   ///< of a face: points this near to an edge of the master are put on it
    double rim = 0.1;     ///< of a face: rims of the sides this near are one; the distance of the surfaces there is added
    double sliver = 1e-8; ///< of the smaller face: smaller sub-faces are merged with a neighbour
};

/// Sub-faces of two sides; none if the surfaces are apart or only touch at their rims.
[[nodiscard]] SideOverlap overlap(const SideTiling& master, const SideTiling& other, const OverlapTolerance& tolerance = {});

/// What the edges of a side sweep when they bend: [0] those along p, np x (nq + 1), [1] those along q, (np + 1) x nq [m2].
using EdgeSlivers = std::array<Array3<Vec3>, 2>;

/// @param overlaps  All in which the tiling is the other side. Masters that touch on it must have the same vertices there.
[[nodiscard]] EdgeSlivers edge_slivers(const SideTiling& tiling, const std::vector<const SideOverlap*>& overlaps);

/// Area vector of a face whose edges have bent [m2].
[[nodiscard]] Vec3 bent_area(const SideTiling& tiling, const EdgeSlivers& slivers, int p, int q);

} // namespace core
