// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/bed_layers.hpp"
#include "io/files/exact_sums.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

constexpr double layers_per_diameter = 5.0;

/// The layers that a body from `low` to `high` lies in, one after the other: part(layer, height up to which it lies in this one or below).
template <class Part>
void for_each_layer(const BedLayers& layers, std::size_t count, double low, double high, Part part)
{
    const auto layer_at = [&](double h) { return std::size_t(std::clamp((h - layers.lowest) / layers.thickness, 0.0, double(count) - 1)); };
    for (std::size_t n = layer_at(low), last = layer_at(high); n <= last; ++n)
        part(n, n < last ? layers.lowest + double(n + 1) * layers.thickness : high);
}

/// Least and greatest height of the corners of a cell [m].
std::array<double, 2> heights_of(const core::Vertices& vertices, int i, int j, int k, int axis, double up)
{
    std::array<double, 2> ends{1e300, -1e300};
    for (int n = 0; n < 8; ++n) {
        const double h = up * vertices(i + (n & 1), j + (n >> 1 & 1), k + (n >> 2))[axis];
        ends = {std::min(ends[0], h), std::max(ends[1], h)};
    }
    return ends;
}

} // namespace

double volume_below(double radius, double height)
{
    const double h = std::clamp(height, -radius, radius) + radius; // of the cap
    return std::numbers::pi / 3.0 * h * h * (3.0 * radius - h);
}

BedLayering::BedLayering(const World& world)
{
    const core::Vec3& down = world.scene().gravity->direction;
    down.cwiseAbs().maxCoeff(&axis_);
    up_ = down[axis_] > 0 ? -1.0 : 1.0;
    const Grid& grid = world.scene().grid;
    const double height = (grid.high() - grid.low())[axis_], diameter = std::min(world.census().smallest, height);
    const auto count = std::size_t(std::ceil(layers_per_diameter * height / diameter));
    area_ = world.mesh().total_volume() / height;
    empty_.lowest = up_ > 0 ? grid.low()[axis_] : -grid.high()[axis_];
    empty_.thickness = height / double(count);
    empty_.room = room_of(world, count);
}

/// Between its lowest and its highest corner a cell is taken to be as wide everywhere.
std::vector<double> BedLayering::room_of(const World& world, std::size_t count) const
{
    std::vector<std::vector<double>> columns(count);
    const core::Mesh& mesh = world.mesh();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const auto [low, high] = heights_of(mesh.vertices(mesh.global(b)), i, j, k, axis_, up_);
            const double volume = mesh.geometry(b).volume(i, j, k);
            double from = low;
            for_each_layer(empty_, count, low, high, [&](std::size_t n, double to) {
                columns[n].push_back(volume * (to - from) / (high - low));
                from = to;
            });
        });
    return exact_sums(world.ranks(), columns);
}

BedLayers BedLayering::of(const World& world) const
{
    const std::size_t count = empty_.room.size(), kinds = world.scene().particles.size();
    std::vector<std::vector<double>> columns((1 + kinds) * count);
    const core::ParticleSet& p = world.grains()->particles;
    const double origin = world.grains()->domain().origin[axis_];
    for (int i = 0; i < p.owned; ++i) {
        const auto at = std::size_t(i);
        const double radius = p.radius[at], middle = up_ * (origin + p.position_of(i)[axis_]), speed = p.velocity_of(i).norm();
        double below = 0;
        for_each_layer(empty_, count, middle - radius, middle + radius, [&](std::size_t n, double to) {
            const double volume = volume_below(radius, to - middle) - below;
            below += volume;
            columns[n].push_back(volume * speed);
            columns[(1 + std::size_t(p.species[at])) * count + n].push_back(volume);
        });
    }
    const auto sums = exact_sums(world.ranks(), columns);
    const auto layer_values = [&](std::size_t column) {
        return std::vector<double>(sums.begin() + std::ptrdiff_t(column * count), sums.begin() + std::ptrdiff_t((column + 1) * count));
    };
    BedLayers layers = empty_;
    layers.motion = layer_values(0);
    layers.solid.assign(count, 0.0);
    for (std::size_t s = 0; s < kinds; ++s) {
        layers.solid_of.push_back(layer_values(1 + s));
        for (std::size_t n = 0; n < count; ++n) layers.solid[n] += layers.solid_of[s][n];
    }
    return layers;
}

} // namespace io
