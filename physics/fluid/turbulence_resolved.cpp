// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/turbulence_resolved.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace physics {
namespace {

/// The equations of one place away from walls.
TurbulenceSources resolved_sources(const Turbulence& at, const WallDamping& damping, double viscosity, double strain, double dt)
{
    constexpr const ResolvedConstants& c = k_epsilon_resolved;
    const double rate = at.epsilon / at.k;
    const double produced = production(eddy_viscosity(c.c_mu * damping.viscosity, at, viscosity, strain), strain, at.epsilon);
    return {{1 + dt * rate, at.k + dt * produced}, {1 + dt * c.c_2 * damping.decay * rate, at.epsilon + dt * c.c_1 * produced * rate}};
}

/// Beside walls k decays as in the viscous layer, of several walls at the mean rate.
void set_viscous_layers(const ResolvedWalls& walls, double dt, TurbulenceCells cells, TurbulenceEquations out)
{
    for (const WallCell& at : walls.cells) {
        out.k_source[at.cell] = cells.share[at.cell] * cells.k[at.cell];
        out.k_capacity[at.cell] = out.epsilon_capacity[at.cell] = cells.share[at.cell];
        out.epsilon_source[at.cell] = out.free[at.cell] = 0;
    }
    for (const WallCell& at : walls.cells) {
        const double rate = at.share * viscous_decay(at.distance, walls.viscosity);
        out.k_capacity[at.cell] += cells.share[at.cell] * dt * rate;
        out.epsilon_source[at.cell] += cells.share[at.cell] * rate * cells.k[at.cell];
    }
}

} // namespace

void find_eddy_viscosity(const ResolvedWalls& walls, core::View<const double> k, core::View<const double> epsilon,
                         core::View<const double> strain, core::View<double> out)
{
    map_cells(
        out,
        [nu = walls.viscosity](double energy, double dissipation, double squared, double y) {
            const double c_mu = k_epsilon_resolved.c_mu * wall_damping(energy, dissipation, y, nu).viscosity;
            return eddy_viscosity(c_mu, {energy, dissipation}, nu, squared);
        },
        k, epsilon, strain, walls.distance);
}

void set_wall_viscosity(const ResolvedWalls& walls, core::View<const double>, core::FaceView<double> ratio)
{
    for (const WallCell& at : walls.cells) ratio.along(core::axis_of(at.side))[at.face] = 1.0;
}

void form_sources(const BlockWalls&, const ResolvedWalls& walls, core::VectorView<const double>, double dt, TurbulenceCells cells,
                  TurbulenceEquations out)
{
    core::for_each_cell(cells.k.extents(), [&](int i, int j, int k) {
        const Turbulence at{cells.k(i, j, k), cells.epsilon(i, j, k)};
        const WallDamping damping = wall_damping(at.k, at.epsilon, walls.distance(i, j, k), walls.viscosity);
        const TurbulenceSources s = resolved_sources(at, damping, walls.viscosity, cells.strain(i, j, k), dt);
        const double w = cells.share(i, j, k);
        out.k_capacity(i, j, k) = w * s.k.capacity;
        out.k_source(i, j, k) = w * s.k.source;
        out.epsilon_capacity(i, j, k) = w * s.epsilon.capacity;
        out.epsilon_source(i, j, k) = w * s.epsilon.source;
        out.free(i, j, k) = 1.0;
    });
    set_viscous_layers(walls, dt, cells, out);
}

} // namespace physics
