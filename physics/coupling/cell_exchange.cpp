// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/cell_exchange.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/coupling/true_up.hpp"

namespace physics {

void untold_change(const FluidOwn& own, CellVectors acceleration, core::VectorView<double> advected, core::VectorView<double> miss)
{
    core::for_each_cell(own.velocity.x.extents(), [&](int i, int j, int k) {
        for (int c = 0; c < 3; ++c) {
            const double known = own.drive[c] - own.pressure_gradient.component(c)(i, j, k) / own.density;
            const double ua = own.predicted.component(c)(i, j, k) - own.dt * known;
            advected.component(c)(i, j, k) = ua;
            miss.component(c)(i, j, k) = own.velocity.component(c)(i, j, k) - ua - own.dt * acceleration.component(c)(i, j, k);
        }
    });
}

void predicted_velocity_change(const FluidOwn& own, const GrainSumViews& sums, CellVectors ledger, CellVectors miss,
                               core::VectorView<double> change)
{
    core::for_each_cell(own.velocity.x.extents(), [&](int i, int j, int k) {
        const double phi = 1.0 - sums[sum_solid](i, j, k);
        const GrainResponse response = predictor_sums(sums, i, j, k);
        for (int c = 0; c < 3; ++c) {
            const double force = own.density * own.drive[c] - own.pressure_gradient.component(c)(i, j, k);
            const double u = own.velocity.component(c)(i, j, k);
            const double advected = own.predicted.component(c)(i, j, k) - own.dt * force / own.density;
            const FluidPush push{ledger.component(c)(i, j, k), force, sums[sum_impulse + std::size_t(c)](i, j, k), u, advected,
                                 miss.component(c)(i, j, k)};
            change.component(c)(i, j, k) = predicted_change(push, own.density * phi, phi, response, own.dt);
        }
    });
}

void predicted_volume_flux(const FluidOwn& own, const GrainSumViews& sums, CellVectors change, CellVectors miss,
                           core::View<double> known_mobility, core::VectorView<double> carried)
{
    core::for_each_cell(own.velocity.x.extents(), [&](int i, int j, int k) {
        const double phi = 1.0 - sums[sum_solid](i, j, k);
        const GrainResponse response = predictor_sums(sums, i, j, k);
        const double known = (phi + response.flux) * own.dt * phi / (own.density * phi + response.reaction);
        known_mobility(i, j, k) = known;
        for (int c = 0; c < 3; ++c) {
            const double du = change.component(c)(i, j, k);
            const double flux = phi * (own.velocity.component(c)(i, j, k) + du) + sums[sum_flux + std::size_t(c)](i, j, k) +
                                predicted_solid_flux(du, miss.component(c)(i, j, k), response);
            carried.component(c)(i, j, k) = flux + known * own.pressure_gradient.component(c)(i, j, k);
        }
    });
}

void projection_response(const GrainSumViews& sums, double density, double dt, core::View<double> response, core::View<double> mobility)
{
    core::for_each_cell(response.extents(), [&](int i, int j, int k) {
        const double phi = 1.0 - sums[sum_solid](i, j, k);
        const CellResponse cell = cell_response(density * phi, phi, projection_sums(sums, i, j, k), dt);
        response(i, j, k) = cell.velocity;
        mobility(i, j, k) = cell.mobility;
    });
}

void advection_ledger_of(const core::BlockGeometry& geometry, core::View<const double> fraction, core::View<const double> fraction_before,
                         core::View<const double> fluid_outflow, const FluidOwn& own, CellVectors advected, core::VectorView<double> ledger)
{
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        const double change = fraction(i, j, k) - fraction_before(i, j, k) + own.dt * fluid_outflow(i, j, k) / geometry.volume(i, j, k);
        for (int c = 0; c < 3; ++c) ledger.component(c)(i, j, k) = advection_ledger(own.density, change, advected.component(c)(i, j, k));
    });
}

} // namespace physics
