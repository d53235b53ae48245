// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faces of one side of a block as a surface: places on it by index, and the nearest place to a point.
#include "core/grid/hexahedron.hpp"

namespace core {

/// A face of a side.
struct FaceIndex {
    int p = 0, q = 0;
    bool operator==(const FaceIndex&) const = default;
};

/// A place on a tiling: (p, q) counted along its two axes, whole numbers at vertices, outside of the side by extrapolation.
struct TilingPlace {
    double p = 0, q = 0;
    double gap = 0; ///< distance of the point asked for, over the size of the faces there
};

/// The faces of a side, np x nq of them, counted along the tangential axes in their order.
class SideTiling {
public:
    SideTiling(const Vertices& block, Side side, const Vec3& shift = Vec3::Zero());

    [[nodiscard]] int np() const { return np_; }
    [[nodiscard]] int nq() const { return nq_; }
    [[nodiscard]] const Vec3& vertex(int p, int q) const { return vertices_[std::size_t(p + (np_ + 1) * q)]; }
    /// Cell of the block behind face (p, q).
    [[nodiscard]] Index3 cell(int p, int q) const;
    /// Area vector of a face along increasing p cross increasing q [m2].
    [[nodiscard]] Vec3 area(int p, int q) const;
    /// Point on the straight edges where p or q is a whole number, else of the bilinear face [m].
    [[nodiscard]] Vec3 point(double p, double q) const;
    /// The nearest place to a point, by Newton's method from face to face.
    [[nodiscard]] TilingPlace nearest(const Vec3& x) const;
    /// Where on a line of edges the nearest place to a point lies, so that both sides of the line find the same.
    /// @param axis  0: the line q = `line`, p is returned; 1: the line p = `line`, q is returned.
    /// @param near  The answer to within one edge.
    [[nodiscard]] double nearest_on_line(int axis, int line, const Vec3& x, double near) const;

private:
    [[nodiscard]] TilingPlace start(const Vec3& x) const;

    int np_, nq_;
    Extents cells_;
    Side side_;
    std::vector<Vec3> vertices_;
    std::vector<Vec3> middles_; ///< of the faces [m]
};

/// The two axes of a side, ascending.
[[nodiscard]] std::array<int, 2> tangential_axes(Side side);

} // namespace core
