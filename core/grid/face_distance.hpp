// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far places are from the boundaries of the domain: from their faces themselves, wherever those are.
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"

#include <limits>
#include <span>

namespace core {

/// Distance from x to the nearest point of a triangle [m].
[[nodiscard]] double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);

/// All faces of some boundaries, of all blocks and through all periods, in a tree of boxes.
class FaceDistance {
public:
    /// @param names  Of boundaries; the same on every rank. No message.
    FaceDistance(const Mesh& mesh, std::span<const std::string> names);

    /// Distance to the nearest face, infinite if there is none [m].
    /// @param enough  Some bound of it: the search is faster the closer it is [m].
    [[nodiscard]] double at(const Vec3& x, double enough = std::numeric_limits<double>::infinity()) const;
    /// The same from the centres of the cells of a block.
    [[nodiscard]] Array3<double> of_cells(const BlockGeometry& geometry) const;

private:
    struct Node {
        Vec3 low, high;      ///< of the box about its faces
        int first, last;     ///< faces of a leaf
        int upper_child = 0; ///< the lower one follows the node; 0: a leaf
    };
    int build(int first, int last);
    void search(const Vec3& x, double& nearest) const;

    std::vector<Quad> faces_;
    std::vector<Node> nodes_;
    std::vector<Motion> images_; ///< by which periods carry a place to its images; the first is none
};

} // namespace core
