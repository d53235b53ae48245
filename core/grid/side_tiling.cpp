// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/side_tiling.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

std::array<int, 2> tangential_axes(Side side)
{
    const int n = axis_of(side);
    return {n == 0 ? 1 : 0, n == 2 ? 1 : 2};
}

SideTiling::SideTiling(const Vertices& block, Side side, const Vec3& shift) : np_(0), nq_(0), cells_(cells_of(block)), side_(side)
{
    const auto t = tangential_axes(side);
    np_ = cells_[t[0]];
    nq_ = cells_[t[1]];
    for (int q = 0; q <= nq_; ++q)
        for (int p = 0; p <= np_; ++p) {
            Index3 c;
            c[axis_of(side)] = is_high(side) ? cells_[axis_of(side)] : 0;
            c[t[0]] = p;
            c[t[1]] = q;
            vertices_.push_back(block.view()[c] + shift);
        }
    for (int q = 0; q < nq_; ++q)
        for (int p = 0; p < np_; ++p)
            middles_.push_back(0.25 * (vertex(p, q) + vertex(p + 1, q) + vertex(p, q + 1) + vertex(p + 1, q + 1)));
}

Index3 SideTiling::cell(int p, int q) const
{
    const auto t = tangential_axes(side_);
    Index3 c;
    c[axis_of(side_)] = is_high(side_) ? cells_[axis_of(side_)] - 1 : 0;
    c[t[0]] = p;
    c[t[1]] = q;
    return c;
}

Vec3 SideTiling::area(int p, int q) const { return 0.5 * (vertex(p + 1, q + 1) - vertex(p, q)).cross(vertex(p, q + 1) - vertex(p + 1, q)); }

Vec3 SideTiling::point(double p, double q) const
{
    const int i = std::clamp(int(std::floor(p)), 0, np_ - 1), j = std::clamp(int(std::floor(q)), 0, nq_ - 1);
    const double s = p - i, t = q - j;
    const Vec3 low = (1 - s) * vertex(i, j) + s * vertex(i + 1, j), high = (1 - s) * vertex(i, j + 1) + s * vertex(i + 1, j + 1);
    return (1 - t) * low + t * high;
}

TilingPlace SideTiling::start(const Vec3& x) const
{
    constexpr int samples = 16; // along each axis; from the best of them from neighbour to neighbour
    FaceIndex best;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](int p, int q) {
        if (p < 0 || q < 0 || p >= np_ || q >= nq_) return false;
        const double distance = (middles_[std::size_t(p + np_ * q)] - x).squaredNorm();
        if (distance >= least) return false;
        least = distance;
        best = {p, q};
        return true;
    };
    const int step_p = std::max(1, np_ / samples), step_q = std::max(1, nq_ / samples);
    for (int q = 0; q < nq_; q += step_q)
        for (int p = 0; p < np_; p += step_p) look(p, q);
    for (bool nearer = true; nearer;) {
        nearer = false;
        const FaceIndex from = best;
        for (int q = from.q - 1; q <= from.q + 1; ++q)
            for (int p = from.p - 1; p <= from.p + 1; ++p) nearer = look(p, q) || nearer;
    }
    return {best.p + 0.5, best.q + 0.5, 0};
}

TilingPlace SideTiling::nearest(const Vec3& x) const
{
    constexpr int most_steps = 40;
    constexpr double enough = 1e-13;
    TilingPlace at = start(x);
    for (int step = 0; step < most_steps; ++step) {
        const int i = std::clamp(int(std::floor(at.p)), 0, np_ - 1), j = std::clamp(int(std::floor(at.q)), 0, nq_ - 1);
        const double s = at.p - i, t = at.q - j;
        const Vec3 along_p = (1 - t) * (vertex(i + 1, j) - vertex(i, j)) + t * (vertex(i + 1, j + 1) - vertex(i, j + 1));
        const Vec3 along_q = (1 - s) * (vertex(i, j + 1) - vertex(i, j)) + s * (vertex(i + 1, j + 1) - vertex(i + 1, j));
        const Vec3 miss = x - point(at.p, at.q);
        const double pp = along_p.squaredNorm(), pq = along_p.dot(along_q), qq = along_q.squaredNorm(), determinant = pp * qq - pq * pq;
        const double bp = along_p.dot(miss), bq = along_q.dot(miss);
        const double dp = (qq * bp - pq * bq) / determinant, dq = (pp * bq - pq * bp) / determinant;
        at.p += std::clamp(dp, -1.0, 1.0); // into the next face at most: it has directions of its own
        at.q += std::clamp(dq, -1.0, 1.0);
        at.gap = (x - point(at.p, at.q)).norm() / std::sqrt(std::sqrt(determinant));
        if (std::abs(dp) + std::abs(dq) < enough) break;
    }
    return at;
}

double SideTiling::nearest_on_line(int axis, int line, const Vec3& x, double near) const
{
    const int count = axis == 0 ? np_ : nq_, from = std::clamp(int(std::floor(near)), 0, count - 1);
    const auto at = [&](int n) { return axis == 0 ? vertex(n, line) : vertex(line, n); };
    double best = near, least = std::numeric_limits<double>::infinity();
    for (int n = std::max(0, from - 1); n <= std::min(count - 1, from + 1); ++n) {
        const Vec3 along = at(n + 1) - at(n);
        double share = (x - at(n)).dot(along) / along.squaredNorm();
        if (n > 0) share = std::max(share, 0.0);
        if (n < count - 1) share = std::min(share, 1.0);
        const double distance = (at(n) + share * along - x).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = n + share;
    }
    return best;
}

} // namespace core
