// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/elliptic_system.hpp"
#include "core/grid/sparse_solve.hpp"
#include <algorithm>

namespace core {
namespace {

Index3 moved(Index3 c, int axis, int by)
{
    c[axis] += by;
    return c;
}

} // namespace

EllipticSystem::EllipticSystem(Extents vertices, Curvature kind) : extents_(vertices), kind_(kind)
{
    for (auto* arrays : {&slope_, &curvature_})
        for (auto& array : *arrays) array = Array3<Vec3>(vertices, 0, Vec3::Zero());
}

int EllipticSystem::number(Index3 c) const
{
    const Extents inner{extents_.ni - 2, extents_.nj - 2, extents_.nk - 2};
    const Index3 at{c.i - 1, c.j - 1, c.k - 1};
    return inner.contains(at) ? at.i + inner.ni * (at.j + inner.nj * at.k) : -1;
}

void EllipticSystem::differentiate(const Vertices& block)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto n = std::size_t(extents_[axis]);
        std::vector<Vec3> line(n), slopes(n), curvatures(n);
        Index3 high{extents_.ni, extents_.nj, extents_.nk};
        high[axis] = 1;
        for_each({0, 0, 0}, high, [&](int i, int j, int k) {
            const Index3 start{i, j, k};
            for (std::size_t s = 0; s < n; ++s) line[s] = block.view()[moved(start, axis, int(s))];
            line_slopes(line, slopes);
            line_curvatures(line, kind_, curvatures);
            for (std::size_t s = 0; s < n; ++s) {
                slope_[std::size_t(axis)].view()[moved(start, axis, int(s))] = slopes[s];
                curvature_[std::size_t(axis)].view()[moved(start, axis, int(s))] = curvatures[s];
            }
        });
    }
}

EllipticSystem::Coefficients EllipticSystem::coefficients(Index3 c, const ControlFunctions& control) const
{
    Mat3 jacobian;
    for (int m = 0; m < 3; ++m) jacobian.col(m) = slope_[std::size_t(m)].view()[c];
    const Mat3 g = jacobian.transpose() * jacobian;
    const double square = g.determinant(); // J^2
    Coefficients a{};
    for (int p = 0; p < 3; ++p) {
        const int q = (p + 1) % 3, r = (p + 2) % 3;
        const auto n = std::size_t(p);
        a.pure[n] = g(q, q) * g(r, r) - g(q, r) * g(q, r);
        a.mixed[n] = 2 * (g(p, q) * g(p, r) - g(p, p) * g(q, r));
        a.first[n] = square * control.source[n].view()[c] + a.pure[n] * control.factor[n].view()[c];
    }
    return a;
}

Vec3 EllipticSystem::residual(const Vertices& block, Index3 c, const Coefficients& a) const
{
    Vec3 sum = Vec3::Zero();
    const auto x = block.view();
    for (int p = 0; p < 3; ++p) {
        const int q = (p + 1) % 3, r = (p + 2) % 3;
        const auto n = std::size_t(p);
        const Vec3 cross = 0.25 * (x[moved(moved(c, q, 1), r, 1)] - x[moved(moved(c, q, 1), r, -1)] - x[moved(moved(c, q, -1), r, 1)] +
                                   x[moved(moved(c, q, -1), r, -1)]);
        sum += a.pure[n] * curvature_[n].view()[c] + a.mixed[n] * cross + a.first[n] * slope_[n].view()[c];
    }
    return sum;
}

void EllipticSystem::add_row(Index3 c, const Coefficients& a, double scale)
{
    const int row = number(c);
    const auto add = [&](Index3 at, double value) {
        if (const int column = number(at); column >= 0) entries_.emplace_back(row, column, value * scale);
    };
    for (int p = 0; p < 3; ++p) {
        const int q = (p + 1) % 3, r = (p + 2) % 3;
        const auto n = std::size_t(p);
        add(c, -2 * a.pure[n]);
        for (const int s : {-1, 1}) {
            add(moved(c, p, s), a.pure[n] + 0.5 * s * a.first[n]);
            for (const int t : {-1, 1}) add(moved(moved(c, q, s), r, t), 0.25 * s * t * a.mixed[n]);
        }
    }
}

double EllipticSystem::advance(Vertices& block, const ControlFunctions& control, double relaxation)
{
    const Extents inner{extents_.ni - 2, extents_.nj - 2, extents_.nk - 2};
    if (inner.ni < 1 || inner.nj < 1 || inner.nk < 1) return 0;
    differentiate(block);
    entries_.clear();
    Eigen::MatrixX3d right(inner.size(), 3);
    for_each({1, 1, 1}, {inner.ni + 1, inner.nj + 1, inner.nk + 1}, [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        const Coefficients a = coefficients(c, control);
        const double sum = a.pure[0] + a.pure[1] + a.pure[2];
        if (sum > 0) {
            add_row(c, a, -1 / sum);
            right.row(number(c)) = residual(block, c, a).transpose() / sum;
        } else { // all around has fallen to one line: it waits for its neighbours
            entries_.emplace_back(number(c), number(c), 1.0);
            right.row(number(c)).setZero();
        }
    });
    const Eigen::MatrixX3d move = relaxation * solver_.solved(entries_, right);
    double largest = 0;
    for_each({1, 1, 1}, {inner.ni + 1, inner.nj + 1, inner.nk + 1}, [&](int i, int j, int k) {
        const Vec3 by = move.row(number({i, j, k})).transpose();
        block(i, j, k) += by;
        largest = std::max(largest, by.norm());
    });
    return largest;
}

} // namespace core
