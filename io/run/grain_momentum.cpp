// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/grain_momentum.hpp"
#include "io/build/physics_builder.hpp"
#include "io/files/exact_sums.hpp"
#include <numbers>

namespace io {
namespace {

/// Places of the sums; each is the first of three but the last two.
enum GrainSum : std::size_t { of_grains, of_owed = 3, of_contact = 6, of_taken = 9, of_couple = 12, of_mass = 15, of_volume, grain_sums };

core::Vec3 columns_at(const core::ParticleSet& grains, int first, std::size_t i)
{
    const auto value = [&](int a) { return grains.columns[std::size_t(first + a)][i]; };
    return {value(0), value(1), value(2)};
}

} // namespace

GrainMomentum grain_momentum(const World& world, const core::Vec3& drive)
{
    const core::ParticleSet& grains = world.grains()->particles;
    const physics::GrainExchange& exchange = *world.exchange();
    const auto& at = exchange.columns();
    const double rho = world.fluid()->parameters().density, dt = world.clock().dt;
    const core::Vec3 gravity = gravity_of(world.scene());
    std::vector<std::vector<double>> columns(grain_sums);
    const auto put = [&](GrainSum first, const core::Vec3& x) {
        for (std::size_t a = 0; a < 3; ++a) columns[first + a].push_back(x[int(a)]);
    };
    for (std::size_t i = 0; i < std::size_t(grains.owned); ++i) {
        const double mass = grains.mass[i], radius = grains.radius[i];
        const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        const core::Vec3 velocity = grains.velocity_of(int(i)), contact = columns_at(grains, exchange.wet_columns().impulse, i);
        // All that is not contact, weight or drive is the fluid's.
        const core::Vec3 outer = contact + dt * ((mass - rho * volume) * gravity + rho * volume * drive);
        const core::Vec3 owed = columns_at(grains, at.owed, i);
        put(of_grains, mass * velocity);
        put(of_owed, owed);
        put(of_contact, contact);
        put(of_taken, mass * (velocity - columns_at(grains, at.velocity_before, i)) - outer + owed);
        put(of_couple, exchange.couple(grains, int(i)));
        columns[of_mass].push_back(mass - rho * volume);
        columns[of_volume].push_back(volume);
    }
    const std::vector<double> sums = exact_sums(world.ranks(), columns);
    const auto vector = [&](GrainSum first) { return core::Vec3(sums[first], sums[first + 1], sums[first + 2]); };
    return {vector(of_grains), vector(of_owed), vector(of_contact), vector(of_taken), vector(of_couple), sums[of_mass], sums[of_volume]};
}

} // namespace io
