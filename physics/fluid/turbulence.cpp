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

struct WallLayers {
    core::View<double> produced, free;
};

/// Production and dissipation beside walls; of several walls the mean.
void set_wall_layers(const BlockWalls& sides, const ModelledWalls& walls, core::VectorView<const double> velocity, TurbulenceCells cells,
                     WallLayers out)
{
    for (const WallCell& at : walls.cells) out.produced[at.cell] = cells.epsilon[at.cell] = cells.strain[at.cell] = out.free[at.cell] = 0;
    for (const WallCell& at : walls.cells) {
        const double k = cells.k[at.cell];
        const WallLayer layer = wall_layer(k, at.distance, walls.viscosity, walls.roughness);
        const double slip = slip_speed(sides, at, velocity);
        out.produced[at.cell] += at.share * wall_production(layer, slip, at.distance, walls.viscosity);
        cells.epsilon[at.cell] += at.share * wall_dissipation(layer, k, at.distance, walls.viscosity);
    }
    for (const WallCell& at : walls.cells) cells.epsilon[at.cell] = std::max(cells.epsilon[at.cell], least_turbulence.epsilon);
}

/// Terms that without diffusion make q grow by exp(growth), and where diffusion holds the balance leave it as it is. Growth beyond e
/// in one step goes on as a parabola: the strain that makes it does not last so long.
SourceTerms growing(double q, double growth)
{
    if (growth == 0) return {1, q};
    constexpr double e = 2.718281828459045;
    const double gain = growth > 1 ? e * (growth + 0.5 * (growth - 1) * (growth - 1)) - 1 : std::expm1(growth);
    const double capacity = growth / gain, factor = growth > 1 ? 1 + gain : std::exp(growth);
    return {capacity, capacity * factor * q};
}

} // namespace

void find_eddy_viscosity(const ModelledWalls& walls, core::View<const double> k, core::View<const double> epsilon,
                         core::View<const double> strain, core::View<double> out)
{
    map_cells(
        out,
        [nu = walls.viscosity](double energy, double dissipation, double squared) {
            return eddy_viscosity(k_epsilon.c_mu, {energy, dissipation}, nu, squared);
        },
        k, epsilon, strain);
}

void viscosity_on_faces(const core::BlockGeometry& geometry, const BlockWalls& sides, double viscosity, core::View<const double> eddy,
                        core::FaceView<double> ratio)
{
    for (int axis = 0; axis < 3; ++axis) ratio_along(geometry.face[std::size_t(axis)], axis, viscosity, eddy, ratio.along(axis));
    combine_at_sub_faces(geometry, eddy, ratio,
                         [viscosity](double a, double b, double w) { return 1 + (w * b + (1 - w) * a) / viscosity; });
    for (const core::Side side : core::all_sides)
        if (sides.at(side).kind)
            for_each_side_face(geometry.cells, side, [&](int i, int j, int m) {
                const core::Index3 face{i, j, m};
                ratio.along(core::axis_of(side))[face] = 1 + eddy[cell_at_face(face, side)] / viscosity;
            });
}

void set_wall_viscosity(const ModelledWalls& walls, core::View<const double> k, core::FaceView<double> ratio)
{
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

TurbulenceSources turbulence_sources(const Turbulence& at, double produced, double forcing, double dt)
{
    constexpr const KEpsilonConstants& c = k_epsilon;
    const double rate = at.epsilon / at.k, making = produced * rate / at.k; // production of k is making * k^2 / epsilon
    const double gain = std::max((c.c_1 - 1) * making + forcing, 0.0), loss = c.c_2 - 1;
    const double lost = integral_of_decay(rate, gain, loss, dt), made = making * integral_of_decay(1 / rate, loss, gain, dt);
    return {growing(at.k, made - lost), growing(at.epsilon, c.c_1 * made - c.c_2 * lost)};
}

void find_forcing(TurbulenceEquations equations, TurbulenceCells cells, double dt, core::View<double> forcing)
{
    map_cells(
        forcing,
        [dt](double free, double w, double k, double k_capacity, double k_source, double epsilon, double epsilon_capacity,
             double epsilon_source) {
            const double gained_k = k_capacity * k - k_source, gained_epsilon = epsilon_capacity * epsilon - epsilon_source;
            const bool none = k < 2 * least_turbulence.k || epsilon < 2 * least_turbulence.epsilon;
            return none ? 0.0 : free * (gained_epsilon - epsilon / k * gained_k) / (w * dt * k);
        },
        equations.free, cells.share, cells.k, equations.k_capacity, equations.k_source, cells.epsilon, equations.epsilon_capacity,
        equations.epsilon_source);
}

void form_sources(const BlockWalls& sides, const ModelledWalls& walls, core::VectorView<const double> velocity, double dt,
                  TurbulenceCells cells, TurbulenceEquations out)
{
    const auto produced = out.k_source; // until the sources take its place
    map_cells(
        produced,
        [nu = walls.viscosity](double k, double epsilon, double strain) {
            return production(eddy_viscosity(k_epsilon.c_mu, {k, epsilon}, nu, strain), strain, epsilon);
        },
        cells.k, cells.epsilon, cells.strain);
    map_cells(
        out.free, [](double) { return 1.0; }, cells.k);
    set_wall_layers(sides, walls, velocity, cells, {produced, out.free});
    core::for_each_cell(cells.k.extents(), [&](int i, int j, int k) {
        const Turbulence at{cells.k(i, j, k), cells.epsilon(i, j, k)};
        const double w = cells.share(i, j, k), made = produced(i, j, k);
        const bool free = out.free(i, j, k) > 0;
        // Beside walls epsilon follows k at once: what is lost is lost implicitly.
        const TurbulenceSources s = free ? turbulence_sources(at, made, cells.forcing(i, j, k), dt)
                                         : TurbulenceSources{{1 + dt * at.epsilon / at.k, at.k + dt * made}, {1, at.epsilon}};
        out.k_capacity(i, j, k) = w * s.k.capacity;
        out.k_source(i, j, k) = w * s.k.source;
        out.epsilon_capacity(i, j, k) = w * s.epsilon.capacity;
        out.epsilon_source(i, j, k) = w * s.epsilon.source;
    });
}

} // namespace physics
