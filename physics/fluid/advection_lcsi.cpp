// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/advection_lcsi.hpp"
#include "core/base/error.hpp"
#include "core/grid/halo_map.hpp"
#include "physics/fluid/hermite.hpp"
#include "physics/fluid/index_space.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

/// Cells of a row that are treated together.
constexpr int chunk = 64;

/// Weights of `Points` neighbours along one axis for a chunk of cells: [point][cell].
template <int Points>
struct Weights {
    alignas(64) double w[Points][chunk];

    /// Do any of the cells use this point?
    [[nodiscard]] bool used(int point, int cells) const
    {
        bool any = false;
        for (int l = 0; l < cells; ++l) any |= w[point][l] != 0;
        return any;
    }
    [[nodiscard]] std::array<bool, Points> used_points(int cells) const
    {
        std::array<bool, Points> any;
        for (int p = 0; p < Points; ++p) any[std::size_t(p)] = used(p, cells);
        return any;
    }
    /// Does every cell use the middle point alone?
    [[nodiscard]] bool middle_only(int cells) const
    {
        for (int p = 0; p < Points; ++p)
            if (p != Points / 2 && used(p, cells)) return false;
        return true;
    }
};

void fill(Interpolation interpolation, const double* displacement, int cells, Weights<7>& weights)
{
    if (interpolation == Interpolation::hermite) {
#pragma omp simd
        for (int l = 0; l < cells; ++l) hermite_weights(-displacement[l], &weights.w[0][l], chunk);
    } else {
#pragma omp simd
        for (int l = 0; l < cells; ++l) spline_weights(-displacement[l], &weights.w[0][l], chunk);
    }
}

/// Replaces the weights of the chosen cells by linear ones.
void make_linear(const double* displacement, const unsigned char* chosen, int cells, Weights<7>& weights)
{
    for (int l = 0; l < cells; ++l)
        if (chosen[l]) linear_weights(-displacement[l], &weights.w[0][l], chunk);
}

/// Weights of the points -1, 0, 1 for linear interpolation at -displacement / 2.
void fill_half_way(const double* displacement, int cells, Weights<3>& weights)
{
#pragma omp simd
    for (int l = 0; l < cells; ++l) {
        const double s = std::clamp(-0.5 * displacement[l], -1.0, 1.0);
        weights.w[0][l] = std::max(-s, 0.0);
        weights.w[1][l] = 1 - std::abs(s);
        weights.w[2][l] = std::max(s, 0.0);
    }
}

/// Values of three components for a chunk of cells.
struct Chunk {
    alignas(64) double value[3][chunk];
};

/// The same window of points around every cell of a chunk, each cell with weights of its own.
template <int Points>
class Window {
public:
    Weights<Points> i, j, k;

    /// Sums the components of q over the windows of cells [first, first + cells) of a row.
    void apply(const core::VectorView<const double>& q, core::Index3 first, int cells, Chunk& sum) const
    {
        constexpr int middle = Points / 2;
        const bool along_i = !i.middle_only(cells);
        const std::array<bool, Points> rows = j.used_points(cells), layers = k.used_points(cells);
        for (auto& component : sum.value) std::fill_n(component, cells, 0.0);
        for (int dk = 0; dk < Points; ++dk) {
            if (!layers[std::size_t(dk)]) continue;
            for (int dj = 0; dj < Points; ++dj) {
                if (!rows[std::size_t(dj)]) continue;
                const std::ptrdiff_t row = q.x.offset(first.i, first.j + dj - middle, first.k + dk - middle);
                const double *x = &q.x.at(row), *y = &q.y.at(row), *z = &q.z.at(row);
                if (along_i) add_row(x, y, z, j.w[dj], k.w[dk], cells, sum);
                else add_point(x, y, z, j.w[dj], k.w[dk], cells, sum);
            }
        }
    }

private:
    static void add_point(const double* x, const double* y, const double* z, const double* wj, const double* wk, int cells, Chunk& sum)
    {
#pragma omp simd
        for (int l = 0; l < cells; ++l) {
            const double w = wj[l] * wk[l];
            sum.value[0][l] += w * x[l];
            sum.value[1][l] += w * y[l];
            sum.value[2][l] += w * z[l];
        }
    }
    void add_row(const double* x, const double* y, const double* z, const double* wj, const double* wk, int cells, Chunk& sum) const
    {
        constexpr int middle = Points / 2;
#pragma omp simd
        for (int l = 0; l < cells; ++l) {
            double sx = 0, sy = 0, sz = 0;
#pragma GCC unroll 8
            for (int p = 0; p < Points; ++p) {
                const double w = i.w[p][l];
                sx += w * x[l + p - middle];
                sy += w * y[l + p - middle];
                sz += w * z[l + p - middle];
            }
            const double w = wj[l] * wk[l];
            sum.value[0][l] += w * sx;
            sum.value[1][l] += w * sy;
            sum.value[2][l] += w * sz;
        }
    }
};

/// Calls body(first cell, number of cells) for every chunk of every row.
template <class Body>
void for_each_chunk(core::Extents n, Body body)
{
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j)
            for (int i = 0; i < n.ni; i += chunk) body(core::Index3{i, j, k}, std::min(chunk, n.ni - i));
}

} // namespace

void transport_velocity(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::VectorView<double> out)
{
    const core::Extents n = geometry.cells;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const auto row = [&](const auto& view) { return view.row(j, k); };
            const InverseJacobianRow a(geometry, j, k);
            const double *volume = row(geometry.volume.view()), *fi = row(flux.i), *low_j = row(flux.j), *high_j = flux.j.row(j + 1, k),
                         *low_k = row(flux.k), *high_k = flux.k.row(j, k + 1);
            double *x = row(out.x), *y = row(out.y), *z = row(out.z);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double scale = 0.5 / volume[i];
                const Components rates{scale * (fi[i] + fi[i + 1]), scale * (low_j[i] + high_j[i]), scale * (low_k[i] + high_k[i])};
                const Components w = a.in_space(i, rates);
                x[i] = w.x;
                y[i] = w.y;
                z[i] = w.z;
            }
        }
}

void index_velocity(const core::BlockGeometry& geometry, core::VectorView<const double> transport, const Extrapolation& change,
                    core::VectorView<double> index_velocity)
{
    const core::Extents n = geometry.cells;
    for (int k = -1; k <= n.nk; ++k)
        for (int j = -1; j <= n.nj; ++j) {
            const auto row = [&](const auto& view) { return view.row(j, k); };
            const auto now = change.velocity, old = change.before;
            const InverseJacobianRow a(geometry, j, k);
            const double *wx = row(transport.x), *wy = row(transport.y), *wz = row(transport.z), *ux = row(now.x), *uy = row(now.y),
                         *uz = row(now.z), *bx = row(old.x), *by = row(old.y), *bz = row(old.z);
            double *x = row(index_velocity.x), *y = row(index_velocity.y), *z = row(index_velocity.z);
#pragma omp simd
            for (int i = -1; i <= n.ni; ++i) {
                const Components u = a.of(i, {wx[i] + change.weight * (ux[i] - bx[i]), wy[i] + change.weight * (uy[i] - by[i]),
                                              wz[i] + change.weight * (uz[i] - bz[i])});
                x[i] = u.x;
                y[i] = u.y;
                z[i] = u.z;
            }
        }
}

LongestWay trajectories(core::VectorView<const double> index_velocity, double dt, core::VectorView<double> displacement)
{
    LongestWay longest;
    for_each_chunk(displacement.x.extents(), [&](core::Index3 first, int cells) {
        Window<3> window;
        Chunk path;
        for (int m = 0; m < 3; ++m) {
            const double* u = index_velocity.component(m).row(first.j, first.k) + first.i;
            for (int l = 0; l < cells; ++l) path.value[m][l] = dt * u[l];
        }
        for (int iteration = 0; iteration < 2; ++iteration) {
            fill_half_way(path.value[0], cells, window.i);
            fill_half_way(path.value[1], cells, window.j);
            fill_half_way(path.value[2], cells, window.k);
            window.apply(index_velocity, first, cells, path);
            for (auto& component : path.value)
                for (int l = 0; l < cells; ++l) component[l] *= dt;
        }
        for (int m = 0; m < 3; ++m) {
            double* out = displacement.component(m).row(first.j, first.k) + first.i;
            double most = 0;
#pragma omp simd reduction(max : most)
            for (int l = 0; l < cells; ++l) {
                most = std::max(most, std::abs(path.value[m][l]));
                out[l] = std::clamp(path.value[m][l], -1.0, 1.0);
            }
            if (most <= longest.cells) continue;
            const auto farthest = std::find_if(path.value[m], path.value[m] + cells, [most](double way) { return std::abs(way) == most; });
            longest = {most, {first.i + int(farthest - path.value[m]), first.j, first.k}};
        }
    });
    return longest;
}

void require_within_reach(const LongestWay& way, core::BlockId block, double dt)
{
    constexpr double rounding = 1e-9; // of a way of just one cell
    core::require<core::NumericsError>(way.cells <= 1 + rounding,
                                       core::text("block ", block, ", cell (", way.cell.i, ", ", way.cell.j, ", ", way.cell.k,
                                                  "): in a step of ", dt, " s its water comes from ", way.cells,
                                                  " cells away, stencils and halos reach 1: make the step smaller"));
}

std::array<bool, 3> singular_axes(const core::Topology& topology, core::BlockId block)
{
    std::array<bool, 3> axes{};
    const core::Extents n = topology.cells[std::size_t(block)];
    for (const core::HaloRow& row : core::halo_rows(topology, block, 1, core::HaloShape::full)) {
        if (!row.round_edge) continue;
        for (int m = 0; m < 3; ++m)
            if (row.cell[m] >= 0 && row.cell[m] < n[m]) axes[std::size_t(m)] = true;
    }
    return axes;
}

void advect(const core::BlockGeometry& geometry, core::VectorView<const double> q, core::VectorView<const double> displacement,
            std::array<bool, 3> singular, core::VectorView<double> out, Interpolation interpolation)
{
    const auto near_singular = geometry.near_singular.view();
    // Across the edges: linear along every axis unless all singular edges run along it.
    const bool one_axis = int(singular[0]) + int(singular[1]) + int(singular[2]) == 1;
    for_each_chunk(geometry.cells, [&](core::Index3 first, int cells) {
        Window<7> window;
        const auto row = [&](const auto& view) { return view.row(first.j, first.k) + first.i; };
        const std::array weights{&window.i, &window.j, &window.k};
        for (int m = 0; m < 3; ++m) {
            const double* d = row(displacement.component(m));
            fill(interpolation, d, cells, *weights[std::size_t(m)]);
            if (!one_axis || !singular[std::size_t(m)]) make_linear(d, row(near_singular), cells, *weights[std::size_t(m)]);
        }
        Chunk sum;
        window.apply(q, first, cells, sum);
        for (int c = 0; c < 3; ++c) std::copy_n(sum.value[c], cells, row(out.component(c)));
    });
}

} // namespace physics
