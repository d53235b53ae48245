// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/turbulence.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/side_faces.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {
namespace {

void ratio_along(const core::FaceMetrics& face, int axis, double viscosity, core::View<const double> eddy, core::View<double> ratio)
{
    const core::Extents n = ratio.extents();
    const std::ptrdiff_t back = eddy.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *w = face.weight.view().row(j, k), *nu = eddy.row(j, k);
            double* r = ratio.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) r[i] = 1 + (w[i] * nu[i] + (1 - w[i]) * nu[i - back]) / viscosity;
        }
}

/// Production and dissipation beside walls; of several walls the mean.
void set_wall_layers(const BlockWalls& sides, const WallsOfTurbulence& walls, core::VectorView<const double> velocity,
                     TurbulenceCells cells, core::View<double> free)
{
    for (const WallCell& at : walls.cells) cells.produced[at.cell] = cells.epsilon[at.cell] = free[at.cell] = 0;
    for (const WallCell& at : walls.cells) {
        const double k = cells.k[at.cell];
        const WallLayer layer = wall_layer(k, at.distance, walls.viscosity, walls.roughness);
        const double slip = slip_speed(sides, at, velocity);
        cells.produced[at.cell] += at.share * wall_production(layer, slip, at.distance, walls.viscosity);
        cells.epsilon[at.cell] += at.share * wall_dissipation(layer, k, at.distance, walls.viscosity);
    }
    for (const WallCell& at : walls.cells) cells.epsilon[at.cell] = std::max(cells.epsilon[at.cell], least_turbulence.epsilon);
}

} // namespace

void eddy_viscosity(double viscosity, core::View<const double> k, core::View<const double> epsilon, core::View<double> out)
{
    map_cells(
        out, [viscosity](double energy, double dissipation) { return eddy_viscosity(energy, dissipation, viscosity); }, k, epsilon);
}

void viscosity_on_faces(const core::BlockGeometry& geometry, const BlockWalls& sides, const WallsOfTurbulence& walls,
                        core::View<const double> eddy, core::View<const double> k, core::FaceView<double> ratio)
{
    for (int axis = 0; axis < 3; ++axis) ratio_along(geometry.face[std::size_t(axis)], axis, walls.viscosity, eddy, ratio.along(axis));
    combine_at_sub_faces(geometry, eddy, ratio,
                         [nu = walls.viscosity](double a, double b, double w) { return 1 + (w * b + (1 - w) * a) / nu; });
    for (const core::Side side : core::all_sides)
        if (sides.at(side).kind)
            for_each_side_face(geometry.cells, side, [&](int i, int j, int m) {
                const core::Index3 face{i, j, m};
                ratio.along(core::axis_of(side))[face] = 1 + eddy[cell_at_face(face, side)] / walls.viscosity;
            });
    for (const WallCell& at : walls.cells)
        ratio.along(core::axis_of(at.side))[at.face] = wall_layer(k[at.cell], at.distance, walls.viscosity, walls.roughness).viscosity;
}

void strain(core::VectorView<const double> gradient_x, core::VectorView<const double> gradient_y, core::VectorView<const double> gradient_z,
            core::View<double> out)
{
    map_cells(
        out,
        [](double xx, double yy, double zz, double xy, double yx, double xz, double zx, double yz, double zy) {
            const double third = (xx + yy + zz) / 3;
            const double a = xx - third, b = yy - third, c = zz - third, d = xy + yx, e = xz + zx, f = yz + zy;
            return 2 * (a * a + b * b + c * c) + (d * d + e * e + f * f);
        },
        gradient_x.x, gradient_y.y, gradient_z.z, gradient_x.y, gradient_y.x, gradient_x.z, gradient_z.x, gradient_y.z, gradient_z.y);
}

TurbulenceSources turbulence_sources(const Turbulence& at, double produced, double dt)
{
    const double rate = at.epsilon / at.k;
    const Decay d = decay(dt * rate);
    return {{1 / d.pace.k, at.k * d.left.k / d.pace.k + dt * produced},
            {1 / d.pace.epsilon, at.epsilon * d.left.epsilon / d.pace.epsilon + dt * k_epsilon.c_1 * produced * rate}};
}

void form_sources(const BlockWalls& sides, const WallsOfTurbulence& walls, core::VectorView<const double> velocity, double dt,
                  TurbulenceCells cells, TurbulenceEquations out)
{
    map_cells(
        cells.produced,
        [nu = walls.viscosity](double strain, double k, double epsilon) {
            return production(eddy_viscosity(k, epsilon, nu), strain, epsilon);
        },
        cells.produced, cells.k, cells.epsilon);
    map_cells(
        out.free, [](double) { return 1.0; }, cells.k);
    set_wall_layers(sides, walls, velocity, cells, out.free);
    core::for_each_cell(cells.k.extents(), [&](int i, int j, int k) {
        const Turbulence at{cells.k(i, j, k), cells.epsilon(i, j, k)};
        const TurbulenceSources s = turbulence_sources(at, cells.produced(i, j, k), dt);
        const double w = cells.share(i, j, k);
        out.k_capacity(i, j, k) = w * s.k.capacity;
        out.k_source(i, j, k) = w * s.k.source;
        const bool free = out.free(i, j, k) > 0;
        out.epsilon_capacity(i, j, k) = w * (free ? s.epsilon.capacity : 1.0);
        out.epsilon_source(i, j, k) = w * (free ? s.epsilon.source : at.epsilon);
    });
}

} // namespace physics
