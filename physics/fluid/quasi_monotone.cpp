// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/quasi_monotone.hpp"
#include "physics/fluid/index_space.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace physics {
namespace {

/// Cells of a row that are treated together.
constexpr int chunk = 64;

using Row = std::array<const double*, 3>;

/// How far a neighbour counts, by the way of the water from its side [cells]: less than 1 only near a way of nothing, so that
/// round-off in the sign of a way decides nothing.
double share_of(double way)
{
    constexpr double fading = 1e3; // per cell
    return std::min(fading * way, 1.0);
}

/// Shares of the rows below, at and above those of a chunk of cells.
struct RowsBeside {
    alignas(64) double share[3][chunk];
    std::array<bool, 3> used;

    /// @param displacement  Across the rows; a departure point lies at minus its displacement.
    void fill(const double* displacement, int cells)
    {
        double up = 0, down = 0;
#pragma omp simd reduction(max : up, down)
        for (int i = 0; i < cells; ++i) {
            const double from_low = std::max(displacement[i], 0.0), from_high = std::max(-displacement[i], 0.0);
            share[0][i] = share_of(from_low);
            share[1][i] = 1;
            share[2][i] = share_of(from_high);
            up = std::max(up, from_low);
            down = std::max(down, from_high);
        }
        used = {up > 0, true, down > 0};
    }
};

/// What the components in index space lie between around the departure points of a chunk, and what advection gave; all less those of
/// the cell itself.
class Ranges {
public:
    /// @param own           What was advected, from the first cell of the chunk on, as all rows.
    /// @param displacement  Along the row.
    Ranges(const InverseJacobianRow& to_index, const Row& own, const double* displacement, int cells)
        : to_index_(to_index), own_(own), displacement_(displacement), cells_(cells)
    {
        for (std::size_t m = 0; m < 3; ++m) {
            std::fill_n(least_[m], cells_, 0.0);
            std::fill_n(most_[m], cells_, 0.0);
        }
    }
    void compare(const std::array<double*, 3>& advected)
    {
#pragma omp simd
        for (int i = 0; i < cells_; ++i) {
            const Components c = to_index_.of(i, {advected[0][i] - own_[0][i], advected[1][i] - own_[1][i], advected[2][i] - own_[2][i]});
            wanted_[0][i] = c.x;
            wanted_[1][i] = c.y;
            wanted_[2][i] = c.z;
        }
    }
    /// Takes in a row, each cell with its neighbour upstream along the row.
    /// @return Is anything of the chunk out of range?
    bool widen(const Row& q, const double* share_j, const double* share_k)
    {
        const auto [x, y, z] = q;
        const auto [ox, oy, oz] = own_;
        double outside = 0;
#pragma omp simd reduction(max : outside)
        for (int i = 0; i < cells_; ++i) {
            const double d = displacement_[i], share = share_j[i] * share_k[i], share_beside = share * share_of(std::abs(d));
            const double low_x = x[i - 1], low_y = y[i - 1], low_z = z[i - 1]; // all read, so that nothing branches
            const double high_x = x[i + 1], high_y = y[i + 1], high_z = z[i + 1];
            const Components here = to_index_.of(i, {x[i] - ox[i], y[i] - oy[i], z[i] - oz[i]});
            const Components beside =
                to_index_.of(i, {(d > 0 ? low_x : high_x) - ox[i], (d > 0 ? low_y : high_y) - oy[i], (d > 0 ? low_z : high_z) - oz[i]});
            const auto take_in = [&](int m, double a, double b) {
                a *= share;
                b *= share_beside;
                least_[m][i] = std::min(least_[m][i], std::min(a, b));
                most_[m][i] = std::max(most_[m][i], std::max(a, b));
                return std::max(wanted_[m][i] - most_[m][i], least_[m][i] - wanted_[m][i]);
            };
            const double out_x = take_in(0, here.x, beside.x), out_y = take_in(1, here.y, beside.y), out_z = take_in(2, here.z, beside.z);
            outside = std::max(outside, std::max(out_x, std::max(out_y, out_z)));
        }
        return outside > 0;
    }
    void clip(const std::array<double*, 3>& advected) const
    {
#pragma omp simd
        for (int i = 0; i < cells_; ++i) {
            const auto too_much = [&](int m) { return wanted_[m][i] - std::max(least_[m][i], std::min(most_[m][i], wanted_[m][i])); };
            const Components off = to_index_.in_space(i, {too_much(0), too_much(1), too_much(2)});
            advected[0][i] -= off.x;
            advected[1][i] -= off.y;
            advected[2][i] -= off.z;
        }
    }

private:
    InverseJacobianRow to_index_;
    Row own_;
    const double* displacement_;
    int cells_;
    alignas(64) double least_[3][chunk], most_[3][chunk], wanted_[3][chunk];
};

/// The middle row, those beside it, and the corners, as (j, k) = -1 ... 1 + 1: what is nearest is enough for most cells.
constexpr std::array<std::array<std::size_t, 2>, 9> nearest_first{{{1, 1}, {0, 1}, {2, 1}, {1, 0}, {1, 2}, {0, 0}, {2, 0}, {0, 2}, {2, 2}}};

} // namespace

void keep_in_range(const core::BlockGeometry& geometry, core::VectorView<const double> q, core::VectorView<const double> displacement,
                   core::VectorView<double> advected)
{
    const core::Extents n = advected.x.extents();
    const auto from = [](const auto& v, int i, int j, int k) {
        return std::array{v.x.row(j, k) + i, v.y.row(j, k) + i, v.z.row(j, k) + i};
    };
    RowsBeside along_j, along_k;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j)
            for (int first = 0; first < n.ni; first += chunk) {
                const int cells = std::min(chunk, n.ni - first);
                const Row along = from(displacement, first, j, k);
                const auto out = from(advected, first, j, k);
                along_j.fill(along[1], cells);
                along_k.fill(along[2], cells);
                Ranges ranges(InverseJacobianRow(geometry, j, k, first), from(q, first, j, k), along[0], cells);
                ranges.compare(out);
                bool outside = true;
                for (const auto& [dj, dk] : nearest_first)
                    if (outside && along_j.used[dj] && along_k.used[dk])
                        outside = ranges.widen(from(q, first, j + int(dj) - 1, k + int(dk) - 1), along_j.share[dj], along_k.share[dk]);
                if (outside) ranges.clip(out);
            }
}

} // namespace physics
