// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/bed_metrics.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/momentum_ledger.hpp"
#include <algorithm>
#include <cmath>

namespace io {
namespace {

constexpr double fraction_at_the_top = 0.08;
constexpr double slowest_over_fall = 0.02; ///< over sqrt(g d), with which a grain falls by half its diameter

core::Vec3 transport(const World& world, double area)
{
    const core::ParticleSet& p = world.grains()->particles;
    std::vector<std::vector<double>> columns(3, std::vector<double>(std::size_t(p.owned)));
    for (int i = 0; i < p.owned; ++i) {
        const core::Vec3 flux = volume_below(p.radius[std::size_t(i)], p.radius[std::size_t(i)]) * p.velocity_of(i);
        for (int a = 0; a < 3; ++a) columns[std::size_t(a)][std::size_t(i)] = flux[a];
    }
    const auto sums = exact_sums(world.ranks(), columns);
    return core::Vec3(sums[0], sums[1], sums[2]) / area;
}

MovingLayer moving_layer_of(const World& world, const BedLayers& layers)
{
    return moving_layer(layers, slowest_over_fall * std::sqrt(world.scene().gravity->magnitude * world.census().smallest));
}

/// Volume of the fluid below a height [m3].
double fluid_below(const BedLayers& layers, double height)
{
    double volume = 0;
    for (std::size_t n = 0; n < layers.solid.size(); ++n) {
        const double share = std::clamp((height - layers.lowest) / layers.thickness - double(n), 0.0, 1.0);
        volume += share * (layers.room[n] - layers.solid[n]);
    }
    return volume;
}

} // namespace

MovingLayer moving_layer(const BedLayers& layers, double slowest)
{
    const auto crossing = [&](std::size_t n, double at, double above, double level) { // between the middles of n and n + 1
        return layers.middle(n) + layers.thickness * (at > above ? (at - level) / (at - above) : 0.0);
    };
    const auto fraction = [&](std::size_t n) { return n < layers.solid.size() ? layers.fraction(n) : 0.0; };
    std::size_t n = layers.solid.size();
    while (n > 0 && layers.fraction(n - 1) < fraction_at_the_top) --n;
    if (n == 0) return {layers.lowest, layers.lowest};
    --n;
    const double top = crossing(n, fraction(n), fraction(n + 1), fraction_at_the_top);
    if (layers.speed(n) <= slowest) return {top, top};
    while (n > 0 && layers.speed(n - 1) > slowest) --n;
    if (n == 0) return {top, layers.lowest};
    const double below = layers.speed(n - 1), at = layers.speed(n);
    return {top, std::min(top, layers.middle(n - 1) + layers.thickness * (slowest - below) / (at - below))};
}

MetricGroup bed_metrics(World& world)
{
    return {{"transport_x", "transport_y", "transport_z", "bed_top", "moving_layer"}, [&world, bed = BedLayering(world)] {
                const core::Vec3 moved = transport(world, bed.area());
                const MovingLayer layer = moving_layer_of(world, bed.of(world));
                return std::vector<double>{moved.x(), moved.y(), moved.z(), layer.top, layer.thickness()};
            }};
}

MetricGroup bed_stress_metrics(World& world, const MomentumLedger& ledger)
{
    return {{"bed_stress_x", "bed_stress_y", "bed_stress_z"}, [&world, &ledger, bed = BedLayering(world)] {
                const BedLayers layers = bed.of(world);
                const double domain = world.mesh().total_volume(), dt = world.clock().dt_before;
                const double below = fluid_below(layers, moving_layer_of(world, layers).top) / domain;
                const MomentumImpulses& step = ledger.impulses();
                const core::Vec3 impulse = step.given - step.viscous_share - step.wall_friction - below * step.drive;
                const core::Vec3 stress = dt > 0 ? core::Vec3(impulse / (dt * bed.area())) : core::Vec3(core::Vec3::Zero());
                return std::vector<double>{stress.x(), stress.y(), stress.z()};
            }};
}

} // namespace io
