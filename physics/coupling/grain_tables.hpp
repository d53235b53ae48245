// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small words for columns and tables of grains, three components at a time.
#include "core/base/vec3.hpp"
#include "core/particles/particle_set.hpp"
#include <numbers>
#include <vector>

namespace physics::grain_tables {

[[nodiscard]] inline double volume_of(const core::ParticleSet& grains, int g)
{
    constexpr double sphere = std::numbers::pi / 6.0;
    const double r = grains.radius[std::size_t(g)];
    return 8.0 * sphere * (r * r * r);
}

/// Columns first, first + 1, first + 2 of a table.
[[nodiscard]] inline core::Vec3 at(const std::vector<std::vector<double>>& table, std::size_t first, int g)
{
    const auto k = std::size_t(g);
    return {table[first][k], table[first + 1][k], table[first + 2][k]};
}

inline void put(core::ParticleSet& grains, int first, int g, const core::Vec3& value)
{
    for (int a = 0; a < 3; ++a) grains.columns[std::size_t(first + a)][std::size_t(g)] = value[a];
}

} // namespace physics::grain_tables
