// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/cell_exchange.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace physics {

void mixture_flux(CellVectors velocity, const GrainSumViews& sums, core::VectorView<double> flux)
{
    for (std::size_t c = 0; c < 3; ++c)
        map_cells(flux.component(int(c)), [](double u, double solid, double carried) { return (1.0 - solid) * u + carried; },
                  velocity.component(int(c)), sums[sum_solid], sums[sum_flux + c]);
}

void fluid_velocity(CellVectors flux, const GrainSumViews& sums, core::VectorView<double> velocity)
{
    for (std::size_t c = 0; c < 3; ++c)
        map_cells(velocity.component(int(c)), [](double q, double solid, double carried) { return (q - carried) / (1.0 - solid); },
                  flux.component(int(c)), sums[sum_solid], sums[sum_flux + c]);
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
            const double taken = impulse_taken(sums[sum_impulse + std::size_t(c)](i, j, k), sums[sum_held](i, j, k), u);
            const FluidPush push{ledger.component(c)(i, j, k), force, taken, u,
                                 own.advected.component(c)(i, j, k), miss.component(c)(i, j, k)};
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

void unpaid_impulse(const FluidOwn& own, const GrainSumViews& sums, const FluidAnswer& answer, core::VectorView<double> ledger)
{
    core::for_each_cell(own.velocity.x.extents(), [&](int i, int j, int k) {
        const double phi = 1.0 - sums[sum_solid](i, j, k);
        const GrainResponse p = predictor_sums(sums, i, j, k), q = projection_sums(sums, i, j, k);
        for (int c = 0; c < 3; ++c) {
            const auto at = [&](const CellVectors& field) { return field.component(c)(i, j, k); };
            const double force = own.density * own.drive[c] - at(own.pressure_gradient);
            double& left = ledger.component(c)(i, j, k);
            const double told = at(own.velocity) - (at(answer.change) - answer.response(i, j, k) * at(answer.gradient_change));
            const double taken = impulse_taken(sums[sum_impulse + std::size_t(c)](i, j, k), sums[sum_held](i, j, k), told);
            const FluidPush push{left, force, taken, at(own.velocity), at(own.advected), at(answer.miss)};
            left = impulse_on_fluid(push, own.density * phi, phi, p, own.dt) - p.reaction * at(answer.change) -
                   (own.dt * (phi + q.flux) - q.reaction * answer.response(i, j, k)) * at(answer.gradient_change);
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

} // namespace physics
