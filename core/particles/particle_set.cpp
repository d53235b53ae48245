// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/particle_set.hpp"
#include "core/base/error.hpp"

#include <numbers>

namespace core {
namespace {

template <class T>
void pick(std::vector<T>& values, std::span<const int> order)
{
    std::vector<T> picked(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) picked[k] = values[std::size_t(order[k])];
    values.swap(picked);
}

} // namespace

int ParticleSet::add_column()
{
    columns.emplace_back(std::size_t(owned), 0.0);
    return int(columns.size()) - 1;
}

void ParticleSet::add(const Sphere& s)
{
    require<ConfigError>(s.radius > 0 && s.density > 0 && s.id >= 0, text("particle ", s.id, ": radius ", s.radius, " m and density ",
                                                                          s.density, " kg/m3 must be positive and the id not negative"));
    resize_owned(owned + 1);
    const auto i = std::size_t(owned - 1);
    for (std::size_t k = 0; k < 3; ++k) {
        position[k][i] = s.position[int(k)];
        velocity[k][i] = s.velocity[int(k)];
        spin[k][i] = s.spin[int(k)];
    }
    radius[i] = s.radius;
    mass[i] = 4.0 / 3.0 * std::numbers::pi * s.radius * s.radius * s.radius * s.density;
    inertia[i] = 0.4 * mass[i] * s.radius * s.radius;
    id[i] = s.id;
    species[i] = s.species;
}

void ParticleSet::resize_owned(int n)
{
    owned = n;
    for (auto& column : columns) column.resize(std::size_t(n));
    resize_ghosts(0);
}

void ParticleSet::resize_ghosts(int n)
{
    const auto total = std::size_t(owned + n);
    const auto fit = [&](auto& column) {
        if (n > 0) column.reserve(total); // resize() would double the room; one by one, as owned particles come, that is welcome
        column.resize(total);
    };
    for (auto* triple : {&position, &velocity, &spin})
        for (auto& column : *triple) fit(column);
    for (auto* column : {&radius, &mass, &inertia}) fit(*column);
    fit(id);
    fit(species);
}

void ParticleSet::reorder(std::span<const int> order)
{
    for_each_column(*this, [&](Column& column) { pick(column, order); });
    pick(id, order);
    pick(species, order);
    owned = int(order.size());
}

} // namespace core
