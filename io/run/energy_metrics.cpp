// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/physics_builder.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/metric_groups.hpp"

namespace io {

MetricGroup energy_metrics(World& world)
{
    return {{"energy_kinetic", "energy_rotational", "energy_potential", "energy_elastic", "energy_damped", "energy_of_friction",
             "energy_of_turning", "energy_from_walls"},
            [&world] {
                const physics::ParticleDynamics& grains = *world.grains();
                const core::ParticleSet& p = grains.particles;
                const core::Vec3 gravity = gravity_of(world.scene()), origin = grains.domain().origin;
                std::vector<std::vector<double>> columns(8);
                for (int i = 0; i < p.owned; ++i) {
                    const auto n = std::size_t(i);
                    columns[0].push_back(0.5 * p.mass[n] * p.velocity_of(i).squaredNorm());
                    columns[1].push_back(0.5 * p.inertia[n] * p.spin_of(i).squaredNorm());
                    columns[2].push_back(-p.mass[n] * gravity.dot(origin + p.position_of(i)));
                    const auto& energy = grains.energy();
                    std::size_t next = 3;
                    for (const int column : {energy.elastic, energy.damping, energy.friction, energy.turning, energy.walls})
                        columns[next++].push_back(p.columns[std::size_t(column)][n]);
                }
                return exact_sums(world.ranks(), columns);
            }};
}

} // namespace io
