// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/quasi_monotone.hpp"
#include <algorithm>
#include <array>

namespace physics {
namespace {

/// Cells of a row that are treated together.
constexpr int chunk = 64;

/// What the values around the departure points of a chunk lie between.
struct Ranges {
    alignas(64) double least[chunk], most[chunk];
    int cells;

    void start(const double* middle)
    {
        std::copy_n(middle, cells, least);
        std::copy_n(middle, cells, most);
    }
    /// Takes in the cells of a row and their neighbours upstream along it.
    /// @param x, j, k  The row, and how far it lies beside the middle one.
    /// @param along    Displacements; a departure point lies at minus its displacement.
    void widen(const double* x, int j, int k, const std::array<const double*, 3>& along)
    {
        const auto [di, dj, dk] = along;
#pragma omp simd
        for (int i = 0; i < cells; ++i) {
            const double here = x[i], before = x[i - 1], behind = x[i + 1]; // all read, so that nothing branches
            const double beside = di[i] > 0 ? before : behind;
            const double low = std::min(here, beside), high = std::max(here, beside);
            const bool upstream = (j * dj[i] <= 0) & (k * dk[i] <= 0);
            least[i] = upstream ? std::min(least[i], low) : least[i];
            most[i] = upstream ? std::max(most[i], high) : most[i];
        }
    }
    void clip(double* value) const
    {
#pragma omp simd
        for (int i = 0; i < cells; ++i) value[i] = std::max(least[i], std::min(most[i], value[i]));
    }
};

} // namespace

void keep_in_range(core::VectorView<const double> q, core::VectorView<const double> displacement, core::VectorView<double> advected)
{
    const core::Extents n = advected.x.extents();
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < n.nk; ++k)
            for (int j = 0; j < n.nj; ++j)
                for (int first = 0; first < n.ni; first += chunk) {
                    const auto from_first = [=](const auto& view, int row, int layer) { return view.row(row, layer) + first; };
                    const std::array<const double*, 3> along{from_first(displacement.x, j, k), from_first(displacement.y, j, k),
                                                             from_first(displacement.z, j, k)};
                    Ranges ranges;
                    ranges.cells = std::min(chunk, n.ni - first);
                    ranges.start(from_first(q.component(c), j, k));
                    for (int dk = -1; dk <= 1; ++dk)
                        for (int dj = -1; dj <= 1; ++dj) ranges.widen(from_first(q.component(c), j + dj, k + dk), dj, dk, along);
                    ranges.clip(from_first(advected.component(c), j, k));
                }
}

} // namespace physics
