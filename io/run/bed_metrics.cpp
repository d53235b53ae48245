// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/bed_metrics.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/momentum_ledger.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

constexpr double fraction_at_the_top = 0.08;
constexpr double layers_per_diameter = 5.0;
constexpr double slowest_over_fall = 0.02; ///< over sqrt(g d), with which a grain falls by half its diameter

/// The axis of the grid that is closest to gravity, and whether it points up.
struct Upwards {
    int axis;
    double sign;
};

Upwards upwards(const World& world)
{
    const core::Vec3& down = world.scene().gravity->direction;
    int axis = 0;
    down.cwiseAbs().maxCoeff(&axis);
    return {axis, down[axis] > 0 ? -1.0 : 1.0};
}

double floor_area(const World& world)
{
    const Grid& grid = world.scene().grid;
    return grid.volume() / (grid.high() - grid.low())[upwards(world).axis];
}

/// 1 m without grains: nothing is measured then.
double smallest_diameter(const World& world)
{
    const core::ParticleSet& p = world.grains()->particles;
    double least = -1e300;
    for (int i = 0; i < p.owned; ++i) least = std::max(least, -2.0 * p.radius[std::size_t(i)]);
    world.ranks().max(std::span(&least, 1));
    return least > -1e300 ? -least : 1.0;
}

core::Vec3 transport(const World& world)
{
    const core::ParticleSet& p = world.grains()->particles;
    std::vector<std::vector<double>> columns(3, std::vector<double>(std::size_t(p.owned)));
    for (int i = 0; i < p.owned; ++i) {
        const core::Vec3 flux = volume_below(p.radius[std::size_t(i)], p.radius[std::size_t(i)]) * p.velocity_of(i);
        for (int a = 0; a < 3; ++a) columns[std::size_t(a)][std::size_t(i)] = flux[a];
    }
    const auto sums = exact_sums(world.ranks(), columns);
    return core::Vec3(sums[0], sums[1], sums[2]) / floor_area(world);
}

MovingLayer moving_layer_of(const World& world, const BedLayers& layers)
{
    return moving_layer(layers, slowest_over_fall * std::sqrt(world.scene().gravity->magnitude * smallest_diameter(world)));
}

/// Volume of the fluid below a height [m3].
double fluid_below(const BedLayers& layers, double height)
{
    double volume = 0;
    for (std::size_t n = 0; n < layers.solid.size(); ++n) {
        const double share = std::clamp((height - layers.lowest) / layers.thickness - double(n), 0.0, 1.0);
        volume += share * (layers.area * layers.thickness - layers.solid[n]);
    }
    return volume;
}

} // namespace

double volume_below(double radius, double height)
{
    const double h = std::clamp(height, -radius, radius) + radius; // of the cap
    return std::numbers::pi / 3.0 * h * h * (3.0 * radius - h);
}

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

BedLayers bed_layers(const World& world)
{
    const auto [axis, sign] = upwards(world);
    const Grid& grid = world.scene().grid;
    const double height = (grid.high() - grid.low())[axis];
    BedLayers layers;
    layers.lowest = sign > 0 ? grid.low()[axis] : -grid.high()[axis];
    const auto count = std::size_t(std::ceil(layers_per_diameter * height / smallest_diameter(world)));
    layers.thickness = height / double(count);
    layers.area = floor_area(world);
    std::vector<std::vector<double>> columns(2 * count);
    const core::ParticleSet& p = world.grains()->particles;
    const double origin = world.grains()->domain().origin[axis];
    for (int i = 0; i < p.owned; ++i) {
        const double radius = p.radius[std::size_t(i)], middle = sign * (origin + p.position_of(i)[axis]), speed = p.velocity_of(i).norm();
        const auto layer_at = [&](double h) {
            return std::size_t(std::clamp((h - layers.lowest) / layers.thickness, 0.0, double(count) - 1));
        };
        double below = 0;
        for (std::size_t n = layer_at(middle - radius), last = layer_at(middle + radius); n <= last; ++n) {
            const double end = n < last ? layers.lowest + double(n + 1) * layers.thickness - middle : radius;
            const double volume = volume_below(radius, end) - below;
            below += volume;
            columns[n].push_back(volume);
            columns[count + n].push_back(volume * speed);
        }
    }
    const auto sums = exact_sums(world.ranks(), columns);
    layers.solid.assign(sums.begin(), sums.begin() + std::ptrdiff_t(count));
    layers.motion.assign(sums.begin() + std::ptrdiff_t(count), sums.end());
    return layers;
}

MetricGroup bed_metrics(World& world)
{
    return {{"transport_x", "transport_y", "transport_z", "bed_top", "moving_layer"}, [&world] {
                const core::Vec3 moved = transport(world);
                const MovingLayer layer = moving_layer_of(world, bed_layers(world));
                return std::vector<double>{moved.x(), moved.y(), moved.z(), layer.top, layer.thickness()};
            }};
}

MetricGroup bed_stress_metrics(World& world, const MomentumLedger& ledger)
{
    return {{"bed_stress_x", "bed_stress_y", "bed_stress_z"}, [&world, &ledger] {
                const BedLayers layers = bed_layers(world);
                const double domain = world.mesh().total_volume(), dt = world.clock().dt_before;
                const double below = fluid_below(layers, moving_layer_of(world, layers).top) / domain;
                const MomentumImpulses& step = ledger.impulses();
                const core::Vec3 impulse = step.given - step.viscous_share - step.wall_friction - below * step.drive;
                const core::Vec3 stress = dt > 0 ? core::Vec3(impulse / (dt * layers.area)) : core::Vec3(core::Vec3::Zero());
                return std::vector<double>{stress.x(), stress.y(), stress.z()};
            }};
}

} // namespace io
