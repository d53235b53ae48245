// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/grain_exchange.hpp"
#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/grain_tables.hpp"
#include "physics/coupling/true_up.hpp"

namespace physics {

using grain_tables::at, grain_tables::put, grain_tables::volume_of;
ExchangeColumns add_exchange_columns(core::ParticleSet& grains, const CouplingParameters& parameters)
{
    const auto three = [&] {
        const int first = grains.add_column();
        grains.add_column();
        grains.add_column();
        return first;
    };
    ExchangeColumns c{};
    c.owed = three();
    c.delivered = three();
    c.told = three();
    c.hold = grains.add_column();
    c.untold = three();
    c.velocity_before = three();
    c.spin_before = three();
    c.known_force = three();
    c.force_used = three();
    c.extra_force = parameters.force == FluidForce::material_derivative ? three() : -1;
    c.drag = grains.add_column();
    c.drag_before = grains.add_column();
    c.yield = grains.add_column();
    c.growth = grains.add_column();
    c.smooth = grains.add_column();
    c.velocity_used = three();
    c.velocity_first = three();
    c.added_mass = grains.add_column();
    c.wake = parameters.own_disturbance ? three() : -1;
    c.fluctuation = parameters.dispersion ? three() : -1;
    c.fluctuation_met = parameters.dispersion ? three() : -1;
    c.history = parameters.history ? grains.add_column() : -1;
    for (int n = 1; parameters.history && n < history_columns; ++n) grains.add_column();
    return c;
}

core::Vec3 GrainExchange::column(const core::ParticleSet& grains, int first, int g) const
{
    const auto value = [&](int a) { return grains.columns[std::size_t(first + a)][std::size_t(g)]; };
    return {value(0), value(1), value(2)};
}

GrainCoupling GrainExchange::coupling_of(const core::ParticleSet& grains, int g, double dt) const
{
    const auto k = std::size_t(g);
    return {grains.mass[k], volume_of(grains, g), dt * grains.columns[std::size_t(columns_.drag)][k],
            grains.columns[std::size_t(columns_.added_mass)][k], grains.columns[std::size_t(columns_.growth)][k]};
}

double GrainExchange::drag_rate(const core::ParticleSet& grains, int g, double fraction) const
{
    const auto k = std::size_t(g);
    double drag = grains.columns[std::size_t(columns_.drag)][k];
    if (drag == 0.0) {
        const double weight = std::abs(grains.mass[k] - parameters_.fluid_density * volume_of(grains, g)) * parameters_.gravity.norm();
        drag = settling_drag(parameters_, weight, fraction, 2.0 * grains.radius[k]);
    }
    return drag / grains.mass[k];
}

double GrainExchange::volume(const core::ParticleSet& grains, int g) { return volume_of(grains, g); }

core::Vec3 GrainExchange::couple(const core::ParticleSet& grains, int g) const
{
    const core::Vec3 gained = grains.inertia[std::size_t(g)] * (grains.spin_of(g) - column(grains, columns_.spin_before, g));
    return gained - column(grains, wet_.twist, g);
}

GrainImpulses GrainExchange::impulses_of(const core::ParticleSet& grains, int g) const
{
    const core::Vec3 contact = column(grains, wet_.impulse, g);
    const core::Vec3 gained = grains.mass[std::size_t(g)] * (grains.velocity_of(g) - column(grains, columns_.velocity_before, g));
    return {contact, gained - contact};
}

std::vector<GrainImpulses> GrainExchange::impulses(const core::ParticleSet& grains) const
{
    std::vector<GrainImpulses> all(std::size_t(grains.owned));
    for (int g = 0; g < grains.owned; ++g) all[std::size_t(g)] = impulses_of(grains, g);
    return all;
}

void GrainExchange::answer(const core::ParticleSet& grains, const Told& told, GrainTable& deposits) const
{
    const double dt = told.dt;
    deposits.resize(grain_sums);
    for (auto& d : deposits) d.resize(std::size_t(grains.owned));
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const GrainCoupling coupling = coupling_of(grains, g, dt);
        const core::Vec3 velocity = grains.velocity_of(g);
        const core::Vec3 impulse = coupling.mass * (velocity - column(grains, columns_.velocity_before, g)) -
                                   dt * column(grains, columns_.known_force, g) - column(grains, wet_.impulse, g);
        const double hold = told.holds[g];
        const GrainResponse p = response_to_velocity(coupling, predictor_yield(hold));
        const GrainResponse q = response_to_pressure(coupling, projection_yield(hold, coupling.drag / coupling.mass));
        const double held = held_drag(p, hold);
        const core::Vec3 velocity_told = at(told.views, view_velocity, g);
        const core::Vec3 around = impulse + p.added * column(grains, columns_.untold, g) - held * velocity_told +
                                  (p.reaction - p.added) * (velocity_told - column(grains, columns_.velocity_used, g));
        deposits[sum_solid][k] = coupling.volume;
        for (std::size_t a = 0; a < 3; ++a) {
            deposits[sum_flux + a][k] = coupling.volume * velocity[int(a)];
            deposits[sum_impulse + a][k] = around[int(a)];
        }
        deposits[sum_predictor][k] = p.reaction;
        deposits[sum_predictor + 1][k] = p.flux;
        deposits[sum_projection][k] = q.reaction;
        deposits[sum_projection + 1][k] = q.flux;
        deposits[sum_projection + 2][k] = q.displaced;
        deposits[sum_held][k] = held;
        deposits[sum_added][k] = p.added;
        deposits[sum_added + 1][k] = p.added_flux;
    }
}

void GrainExchange::owe(core::ParticleSet& grains, const Told& told, const GrainTable& news) const
{
    const double dt = told.dt;
    for (int g = 0; g < grains.owned; ++g) {
        const GrainCoupling coupling = coupling_of(grains, g, dt);
        const double hold = told.holds[g];
        const GrainResponse p = response_to_velocity(coupling, predictor_yield(hold));
        const GrainResponse q = response_to_pressure(coupling, projection_yield(hold, coupling.drag / coupling.mass));
        const auto change = [&](std::size_t view) -> core::Vec3 { return at(news, view, g) - at(told.views, view, g); };
        const core::Vec3 force_new = at(news, view_pressure_force, g) + at(told.views, view_stress, g),
                         velocity_change = change(view_velocity);
        const core::Vec3 force_change = change(view_pressure_force), projection = at(news, news_projection, g);
        const core::Vec3 predictor = velocity_change - projection,
                         miss = dt * change(view_acceleration) - velocity_change + column(grains, columns_.untold, g);
        const core::Vec3 used = column(grains, columns_.force_used, g);
        const GrainImpulses received = impulses_of(grains, g);
        grains.columns[std::size_t(columns_.hold)][std::size_t(g)] =
            contact_share(received.contact.dot(received.applied), received.applied.squaredNorm());
        core::Vec3 owed = column(grains, columns_.owed, g) - column(grains, columns_.delivered, g);
        for (int a = 0; a < 3; ++a)
            owed[a] +=
                owed_impulse({used[a], force_new[a], force_change[a], predictor[a], projection[a], miss[a]}, coupling.volume, p, q, dt);
        owed += (p.reaction - p.added) * (at(told.views, view_velocity, g) - column(grains, columns_.velocity_used, g));
        if (parameters_.viscosity > 0) owed += 0.5 * coupling.volume * dt * (at(news, news_stress, g) - at(told.views, view_stress, g));
        put(grains, columns_.owed, g, owed);
        if (columns_.history >= 0) remember(grains, g, dt);
    }
}

} // namespace physics
