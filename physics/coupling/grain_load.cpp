// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// GrainExchange, step 2: what the fluid puts on each grain before the sub-steps.
#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/drag_laws.hpp"
#include "physics/coupling/grain_exchange.hpp"
#include "physics/coupling/grain_tables.hpp"
#include "physics/coupling/history_force.hpp"
#include "physics/coupling/lift.hpp"
#include "physics/coupling/own_disturbance.hpp"
#include "physics/coupling/torque.hpp"
#include <algorithm>

namespace physics {

using grain_tables::at, grain_tables::put, grain_tables::volume_of;

std::vector<core::Vec3> GrainExchange::wakes(const core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around,
                                             double dt) const
{
    const CouplingParameters& p = parameters_;
    std::vector<core::Vec3> found(std::size_t(grains.owned));
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const double volume = volume_of(grains, g);
        const core::Vec3 before = column(grains, columns_.wake, g), slip = at(views, view_velocity, g) - before - grains.velocity_of(g);
        const double own = own_fraction(volume, p.filter_width, around.spread[k]);
        const double crowding = crowding_fraction(1.0 - around.fraction[k], own) / volume;
        const Wake wake = wake_of({grains.columns[std::size_t(columns_.drag)][k], slip.norm(),
                                   velocity_spread(p.filter_width, around.spread[k]), crowding, p.fluid_density, p.viscosity});
        const double kept = wake.time > 0.0 ? std::exp(-dt / wake.time) : 0.0;
        const core::Vec3 steady = -wake.share * slip;
        found[k] = steady + kept * (before - steady);
    }
    return found;
}

void GrainExchange::take_off(const std::vector<core::Vec3>& wakes, const core::ParticleSet& grains, GrainTable& views,
                             GrainSurroundings& around) const
{
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        for (std::size_t a = 0; a < 3; ++a) views[view_velocity + a][k] -= wakes[k][int(a)];
        const double own = own_fraction(volume_of(grains, g), parameters_.filter_width, around.spread[k]), solid = 1.0 - around.fraction[k];
        constexpr double least = 1e-6; // so that the mean diameter, solid over surface, stays what it is where nothing is left
        const double kept = solid > 0.0 ? std::max(least, fraction_of_others(solid, own) / solid) : 1.0;
        around.fraction[k] = 1.0 - kept * solid;
        if (!around.surface.empty()) around.surface[k] *= kept;
    }
}

void GrainExchange::remember_wakes(core::ParticleSet& grains, const std::vector<core::Vec3>& wakes) const
{
    for (int g = 0; g < grains.owned; ++g) put(grains, columns_.wake, g, wakes[std::size_t(g)]);
}

std::vector<double> GrainExchange::drags(const core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around) const
{
    std::vector<double> drag(std::size_t(grains.owned));
    const auto input = [&](int g) -> DragInput {
        const double slip = (at(views, view_velocity, g) - grains.velocity_of(g)).norm();
        const auto k = std::size_t(g);
        return {slip, around.fraction[k], 2.0 * grains.radius[k], parameters_.fluid_density, parameters_.viscosity};
    };
    with_drag_law(parameters_.drag, [&](const auto& law) {
        if (parameters_.mixture) {
            for (int g = 0; g < grains.owned; ++g) {
                const auto k = std::size_t(g);
                constexpr double least = 1e-12; // of the fraction of solids, below which round-off hides who is around
                const double solid = 1.0 - around.fraction[k];
                drag[k] = drag_in_mixture(law, input(g), solid > least ? solid / around.surface[k] : 2.0 * grains.radius[k]);
            }
        } else {
            for (int g = 0; g < grains.owned; ++g) drag[std::size_t(g)] = law(input(g));
        }
    });
    return drag;
}

void GrainExchange::remember_told(core::ParticleSet& grains, const GrainTable& views) const
{
    for (int g = 0; g < grains.owned; ++g) put(grains, columns_.velocity_used, g, at(views, view_velocity, g));
}

/// Decay of the slip over a step as an exponent, of fluid and grain together.
double GrainExchange::relaxation(const core::ParticleSet& grains, int g, double fraction, double impulse_per_slip) const
{
    const auto k = std::size_t(g);
    const double share = std::max(fraction, smallest_closure_fraction);
    const double loading = grains.mass[k] * (1.0 - share) / (parameters_.fluid_density * volume_of(grains, g) * share);
    return impulse_per_slip / grains.mass[k] * (1.0 + loading);
}

void GrainExchange::freeze_drag(core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around,
                                const GrainStep& step) const
{
    const CouplingParameters& p = parameters_;
    const std::vector<double> drag = drags(grains, views, around);
    const auto column_of = [&](int column) -> core::Column& { return grains.columns[std::size_t(column)]; };
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        double& mass = column_of(columns_.added_mass)[k];
        mass = added_mass(added_mass_coefficient(p, around.fraction[k]), p.fluid_density, volume_of(grains, g));
        if (p.history) mass += history_mass(history_factor(2.0 * grains.radius[k], p.fluid_density, p.viscosity), step.dt);
        const double decay = relaxation(grains, g, around.fraction[k], step.dt * drag[k]), yield = 1.0 - column_of(columns_.hold)[k];
        const double smooth = yield * std::max(0.0, 1.0 - decay), before = column_of(columns_.drag_before)[k];
        const double ahead = before > 0.0 && step.before > 0.0 ? 0.5 * smooth * step.dt / step.before * (drag[k] - before) : 0.0;
        column_of(columns_.yield)[k] = yield;
        column_of(columns_.smooth)[k] = smooth;
        column_of(columns_.growth)[k] = seen_share(growth_share(decay), yield);
        column_of(columns_.drag)[k] = std::clamp(drag[k] + ahead, 0.5 * drag[k], 2.0 * drag[k]);
        column_of(columns_.drag_before)[k] = drag[k];
        put(grains, columns_.velocity_first, g, at(views, view_velocity, g));
    }
}

void GrainExchange::revise(core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around) const
{
    const std::vector<double> now = drags(grains, views, around);
    auto& drag = grains.columns[std::size_t(columns_.drag)];
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const double share = 1.0 - grains.columns[std::size_t(columns_.smooth)][k];
        drag[k] += 0.5 * share * (now[k] - drag[k]);
        grains.columns[std::size_t(columns_.hold)][k] = 0.0;
    }
}

core::Vec3 GrainExchange::lift(const SpinInput& in) const
{
    core::Vec3 force = core::Vec3::Zero();
    if (parameters_.lift) force = magnus_share(parameters_, in.slip.norm(), in.diameter) * magnus_lift(in);
    if (parameters_.shear_lift) force += shear_lift(in);
    return force;
}

core::Vec3 GrainExchange::tell(core::ParticleSet& grains, int g, const core::Vec3& acceleration, double dt) const
{
    const double hold = grains.columns[std::size_t(columns_.hold)][std::size_t(g)];
    const core::Vec3 told = told_acceleration<core::Vec3>(acceleration, column(grains, columns_.told, g), hold);
    put(grains, columns_.told, g, told);
    put(grains, columns_.untold, g, dt * (acceleration - told));
    return told;
}

void GrainExchange::load(core::ParticleSet& grains, const GrainTable& views, const core::Vec3& drive, const GrainStep& step) const
{
    const CouplingParameters& p = parameters_;
    clear_impulses(grains, wet_);
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const double volume = volume_of(grains, g), diameter = 2.0 * grains.radius[k];
        const core::Vec3 velocity = grains.velocity_of(g), fluid = at(views, view_velocity, g), vorticity = at(views, view_vorticity, g);
        const core::Vec3 force = at(views, view_pressure_force, g) + at(views, view_stress, g);
        const double mass = grains.columns[std::size_t(columns_.added_mass)][k];
        const core::Vec3 delivered = step.delivery * column(grains, columns_.owed, g);
        const core::Vec3 known =
            (grains.mass[k] - p.fluid_density * volume) * p.gravity + volume * (force + p.fluid_density * drive) + delivered / step.dt;
        const SpinInput spin{fluid - velocity, vorticity, grains.spin_of(g), diameter, p.fluid_density, p.viscosity};
        WetLoad load;
        load.drag = grains.columns[std::size_t(columns_.drag)][k];
        load.added_mass = mass;
        const core::Vec3 acceleration = at(views, view_acceleration, g) + at(views, view_stress, g) / p.fluid_density;
        const double yield = grains.columns[std::size_t(columns_.yield)][k];
        const GrainCoupling coupling = coupling_of(grains, g, step.dt);
        load.force = known + mass * tell(grains, g, acceleration, step.dt);
        load.force += (delivery_factor(coupling, yield) - 1.0) / step.dt * delivered;
        if (p.lift || p.shear_lift) load.force += lift(spin);
        if (p.history) load.force += history(grains, g, step.dt);
        if (p.force == FluidForce::material_derivative)
            load.force +=
                extra_force(grains, g, p.fluid_density * (at(views, view_acceleration, g) - drive) - at(views, view_pressure_force, g));
        const core::Vec3 first = column(grains, columns_.velocity_first, g);
        load.fluid_velocity = first + coupling.growth * (fluid - first);
        if (p.torque) {
            load.fluid_spin = 0.5 * vorticity;
            load.spin_drag = torque_factor((spin.spin - load.fluid_spin).norm(), diameter, p.fluid_density, p.viscosity);
        }
        set_wet_load(grains, wet_, g, load, step.sub_step);
        put(grains, columns_.delivered, g, delivered);
        put(grains, columns_.velocity_before, g, velocity);
        put(grains, columns_.spin_before, g, spin.spin);
        put(grains, columns_.known_force, g, known);
        put(grains, columns_.force_used, g, force);
    }
}

// The fluid feels the reaction one step late, and in a bed answers C / phi times as much the other way: alternating without
// end from C = 0.5 on. The mean with the step before keeps that quiet up to C = 0.75, beyond every packing.
core::Vec3 GrainExchange::extra_force(core::ParticleSet& grains, int g, const core::Vec3& per_volume) const
{
    const core::Vec3 force = 0.5 * (column(grains, columns_.extra_force, g) + volume_of(grains, g) * per_volume);
    put(grains, columns_.extra_force, g, force);
    return force;
}

} // namespace physics
