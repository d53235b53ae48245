// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/diffusion.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/sub_face_flux.hpp"
#include "physics/fluid/wall_profile.hpp"

namespace physics {

namespace {

/// Of a block whose faces lie straight between cells, without fluxes in between.
void two_point_inflow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q, core::View<double> inflow)
{
    const core::Extents n = geometry.cells;
    const std::ptrdiff_t sj = q.stride(1), sk = q.stride(2);
    const auto ti = geometry.face[0].transmissibility.view(), tj = geometry.face[1].transmissibility.view(),
               tk = geometry.face[2].transmissibility.view();
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *v = q.row(j, k), *t = ti.row(j, k), *low_j = tj.row(j, k), *high_j = tj.row(j + 1, k), *low_k = tk.row(j, k),
                         *high_k = tk.row(j, k + 1);
            double* in = inflow.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i)
                in[i] = (t[i + 1] * (v[i + 1] - v[i]) - t[i] * (v[i] - v[i - 1])) +
                        (high_j[i] * (v[i + sj] - v[i]) - low_j[i] * (v[i] - v[i - sj])) +
                        (high_k[i] * (v[i + sk] - v[i]) - low_k[i] * (v[i] - v[i - sk]));
        }
    for (const core::Side side : core::all_sides) { // the value on the boundary lies half way to the mirror image
        if (!walls.at(side).kind) continue;
        const int axis = core::axis_of(side);
        const auto t = geometry.face[std::size_t(axis)].transmissibility.view();
        const std::ptrdiff_t back = q.stride(axis);
        for_each_side_face(n, side, [&](int i, int j, int k) {
            const std::ptrdiff_t c = q.offset(i, j, k);
            core::Index3 cell{i, j, k};
            if (core::is_high(side)) --cell[axis];
            const double half = 0.5 * t(i, j, k) * (q.at(c) - q.at(c - back));
            inflow[cell] += core::is_high(side) ? -half : half;
        });
    }
    add_bend(geometry, walls, q, inflow);
}

} // namespace

void diffusive_inflow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q,
                      core::VectorView<const double> gradients, const FaceFactors& factors, DiffusiveInflow out)
{
    if (geometry.is_straight() && !factors) return two_point_inflow(geometry, walls, q, out.inflow);
    gradient_flux(geometry, q, gradients, out.flux);
    wall_gradient_flux(geometry, walls, q, out.flux);
    if (!factors) add_bend(geometry, walls, q, out.flux);
    scale_flux(geometry, factors, out.flux);
    net_outflow(out.flux, out.inflow);
}

void scale_flux(const core::BlockGeometry& geometry, const FaceFactors& factors, core::FaceView<double> flux)
{
    if (!factors) return;
    map_faces(
        flux, [](double f, double factor) { return f * factor; }, flux, *factors);
    sum_sub_faces(geometry, flux);
}

void viscous_acceleration(const core::BlockGeometry& geometry, double viscosity, core::View<const double> inflow, core::View<double> out)
{
    const auto volume = geometry.volume.view();
    const core::Extents n = geometry.cells;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *v = volume.row(j, k), *in = inflow.row(j, k);
            double* o = out.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) o[i] = viscosity * in[i] / v[i];
        }
}

void transmissibility_sum(const core::BlockGeometry& geometry, core::View<double> sum)
{
    const auto i_face = geometry.face[0].transmissibility.view(), j_face = geometry.face[1].transmissibility.view(),
               k_face = geometry.face[2].transmissibility.view();
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        sum(i, j, k) =
            i_face(i, j, k) + i_face(i + 1, j, k) + j_face(i, j, k) + j_face(i, j + 1, k) + k_face(i, j, k) + k_face(i, j, k + 1);
    });
}

void transmissibility_sum(const core::BlockGeometry& geometry, core::FaceView<const double> factors, core::View<double> sum)
{
    const auto of = [&](int axis, core::Index3 face) {
        return geometry.face[std::size_t(axis)].transmissibility.view()[face] * factors.along(axis)[face];
    };
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        sum(i, j, k) =
            of(0, {i, j, k}) + of(0, {i + 1, j, k}) + of(1, {i, j, k}) + of(1, {i, j + 1, k}) + of(2, {i, j, k}) + of(2, {i, j, k + 1});
    });
}

} // namespace physics
