// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/hexahedron.hpp"

namespace core {
namespace {

Index3 next(Index3 c, int axis)
{
    ++c[axis];
    return c;
}

} // namespace

Quad face_corners(const Vertices& v, int axis, Index3 c)
{
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    const auto x = v.view();
    return {x[c], x[next(c, p)], x[next(next(c, p), q)], x[next(c, q)]};
}

FaceShape face_shape(const Quad& x)
{
    const Vec3 middle = 0.25 * ((x[0] + x[2]) + (x[1] + x[3]));
    const Vec3 area = 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
    Vec3 moment = Vec3::Zero();
    double total = 0;
    for (std::size_t n = 0; n < 4; ++n) {
        const Vec3& a = x[n];
        const Vec3& b = x[(n + 1) % 4];
        const double size = 0.5 * (a - middle).cross(b - middle).norm();
        moment += size * (a + b + middle) / 3;
        total += size;
    }
    return {area, total > 0 ? Vec3(moment / total) : middle};
}

CellShape cell_shape(const Vertices& v, Index3 c)
{
    const Vec3 origin = v.view()[c];
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const Quad x = face_corners(v, axis, sign > 0 ? next(c, axis) : c);
            const Vec3 middle = 0.25 * ((x[0] + x[2]) + (x[1] + x[3])) - origin;
            for (std::size_t n = 0; n < 4; ++n) {
                const Vec3 a = x[n] - origin, b = x[(n + 1) % 4] - origin;
                const double tetrahedron = sign * middle.dot(a.cross(b)) / 6;
                volume += tetrahedron;
                moment += tetrahedron * (a + b + middle) / 4;
            }
        }
    return {volume, origin + moment / volume};
}

double smallest_corner_jacobian(const Vertices& v, Index3 c)
{
    double smallest = 1;
    for_each({0, 0, 0}, {2, 2, 2}, [&](int i, int j, int k) {
        const Index3 corner{c.i + i, c.j + j, c.k + k};
        Mat3 edges;
        for (int m = 0; m < 3; ++m) {
            Index3 low = corner, high = corner;
            low[m] = c[m];
            high[m] = c[m] + 1;
            edges.col(m) = v.view()[high] - v.view()[low];
        }
        const double scale = edges.col(0).norm() * edges.col(1).norm() * edges.col(2).norm();
        smallest = std::min(smallest, scale > 0 ? edges.determinant() / scale : 0.0);
    });
    return smallest;
}

} // namespace core
