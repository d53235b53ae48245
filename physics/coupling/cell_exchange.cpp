// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/cell_exchange.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"

namespace physics {

void mixture_flux(CellVectors velocity, const GrainSumViews& sums, core::VectorView<double> flux)
{
    for (std::size_t c = 0; c < 3; ++c)
        map_cells(
            flux.component(int(c)), [](double u, double solid, double carried) { return (1.0 - solid) * u + carried; },
            velocity.component(int(c)), sums[sum_solid], sums[sum_flux + c]);
}

void fluid_velocity(CellVectors flux, const GrainSumViews& sums, core::VectorView<double> velocity)
{
    for (std::size_t c = 0; c < 3; ++c)
        map_cells(
            velocity.component(int(c)), [](double q, double solid, double carried) { return (q - carried) / (1.0 - solid); },
            flux.component(int(c)), sums[sum_solid], sums[sum_flux + c]);
}

void flux_density_of_grains(const GrainSumViews& sums, core::VectorView<double> density)
{
    for (std::size_t c = 0; c < 3; ++c)
        map_cells(
            density.component(int(c)), [](double q) { return q; }, sums[sum_flux + c]);
}

void flux_of_grains(const core::BlockGeometry& geometry, const BlockWalls& walls, CellVectors density, core::FaceView<double> flux)
{
    interpolated_flux(geometry, walls, density, flux);
    close_boundaries(walls, flux);
}

void predicted_velocity_change(const FluidOwn& own, const GrainSumViews& sums, CellVectors ledger, CellVectors miss,
                               core::VectorView<double> change)
{
    for (std::size_t c = 0; c < 3; ++c) {
        const int axis = int(c);
        const auto change_of = [density = own.density, dt = own.dt, drive = own.density * own.drive[axis]](
                                   double solid, double impulse, double held, double reaction, double added, double u, double advected,
                                   double gradient, double owed, double untold) {
            const double phi = 1.0 - solid;
            const FluidPush push{owed, drive - gradient, impulse_taken(impulse, held, u), u, advected, untold};
            return predicted_change(push, density * phi, phi, {.reaction = reaction, .added = added}, dt);
        };
        map_cells(change.component(axis), change_of, sums[sum_solid], sums[sum_impulse + c], sums[sum_held], sums[sum_predictor],
                  sums[sum_added], own.velocity.component(axis), own.advected.component(axis), own.pressure_gradient.component(axis),
                  ledger.component(axis), miss.component(axis));
    }
}

void predicted_volume_flux(const FluidOwn& own, const GrainSumViews& sums, CellVectors change, CellVectors miss,
                           core::View<double> known_mobility, core::VectorView<double> carried)
{
    const auto mobility_of = [density = own.density, dt = own.dt](double solid, double reaction, double flux) {
        const double phi = 1.0 - solid;
        return (phi + flux) * dt * phi / (density * phi + reaction);
    };
    map_cells(known_mobility, mobility_of, sums[sum_solid], sums[sum_predictor], sums[sum_predictor + 1]);
    const auto flux_of = [](double solid, double solid_flux, double per_change, double per_miss, double u, double du, double untold,
                            double known, double gradient) {
        const double moved = predicted_solid_flux(du, untold, {.flux = per_change, .added_flux = per_miss});
        return (1.0 - solid) * (u + du) + solid_flux + moved + known * gradient;
    };
    for (std::size_t c = 0; c < 3; ++c) {
        const int axis = int(c);
        map_cells(carried.component(axis), flux_of, sums[sum_solid], sums[sum_flux + c], sums[sum_predictor + 1], sums[sum_added + 1],
                  own.velocity.component(axis), change.component(axis), miss.component(axis), known_mobility,
                  own.pressure_gradient.component(axis));
    }
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
    const auto cell = [density, dt](double solid, double reaction, double flux, double displaced) {
        const double phi = 1.0 - solid;
        return cell_response(density * phi, phi, {.reaction = reaction, .flux = flux, .displaced = displaced}, dt);
    };
    const auto solid = sums[sum_solid], reaction = sums[sum_projection], flux = sums[sum_projection + 1],
               displaced = sums[sum_projection + 2];
    map_cells(
        response, [cell](auto... sum) { return cell(sum...).velocity; }, solid, reaction, flux, displaced);
    map_cells(
        mobility, [cell](auto... sum) { return cell(sum...).mobility; }, solid, reaction, flux, displaced);
}

} // namespace physics
