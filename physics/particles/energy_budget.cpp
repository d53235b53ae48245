// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/energy_budget.hpp"

namespace physics {

EnergyColumns add_energy_columns(core::ParticleSet& particles)
{
    EnergyColumns columns;
    for (int* column : {&columns.elastic, &columns.damping, &columns.friction, &columns.turning, &columns.walls})
        *column = particles.add_column();
    return columns;
}

void begin_budget(const core::ParticleSet& particles, const core::PairList& pairs, const core::NearPairs& near, const PairForces& forces,
                  const ForceSums& sums, EnergySums& energy)
{
    for (int i = sums.begin; i < sums.end; ++i) {
        const auto n = std::size_t(i - sums.begin);
        for (std::size_t a = 0; a < 3; ++a) {
            energy.damping[a][n] = energy.damping_torque[a][n] = energy.resistance[a][n] = 0.0;
            energy.velocity[a][n] = particles.velocity[a][std::size_t(i)];
            energy.spin[a][n] = particles.spin[a][std::size_t(i)];
        }
        energy.elastic[n] = energy.friction[n] = energy.turning[n] = 0.0;
        energy.given[n] = energy.given_damping[n] = energy.given_resistance[n] = 0.0;
        for (int k = pairs.row_begin[std::size_t(i)]; k < near.row_end[std::size_t(i)]; ++k) {
            const int entry = near.row[std::size_t(k)];
            const auto m = std::size_t(entry >> 1);
            const bool is_second = (entry & 1) != 0;
            const double sign = is_second ? -1.0 : 1.0, lever = forces.forces[m].lever(std::size_t(is_second));
            const PairBook& pair = forces.books[m];
            const double force[] = {pair.book.fx, pair.book.fy, pair.book.fz}, couple[] = {pair.book.mx, pair.book.my, pair.book.mz};
            for (std::size_t a = 0; a < 3; ++a) {
                energy.damping[a][n] += sign * force[a];
                energy.damping_torque[a][n] += lever * pair.torque[a];
                energy.resistance[a][n] += sign * couple[a];
            }
            energy.elastic[n] += 0.5 * pair.book.elastic;
            energy.friction[n] += 0.5 * pair.book.friction;
            energy.turning[n] += 0.5 * pair.book.turning;
        }
    }
}

void finish_budget(core::ParticleSet& p, const EnergyColumns& columns, const ForceSums& sums, const EnergySums& energy, double step)
{
    const auto column = [&](int n) { return p.columns[std::size_t(n)].data() + sums.begin; };
    double *elastic = column(columns.elastic), *damping = column(columns.damping);
    double *friction = column(columns.friction), *turning = column(columns.turning), *walls = column(columns.walls);
    for (std::size_t k = 0; k < std::size_t(sums.end - sums.begin); ++k) {
        double damped = energy.given_damping[k], resisted = energy.given_resistance[k], power = damped + resisted - energy.given[k];
        for (std::size_t a = 0; a < 3; ++a) {
            const double v1 = p.velocity[a][std::size_t(sums.begin) + k], w1 = p.spin[a][std::size_t(sums.begin) + k];
            const double v = 0.5 * (energy.velocity[a][k] + v1), w = 0.5 * (energy.spin[a][k] + w1);
            damped -= energy.damping[a][k] * v + energy.damping_torque[a][k] * w;
            resisted -= energy.resistance[a][k] * w;
            power += (sums.force[a][k] - energy.damping[a][k]) * v1;
            power += (sums.torque[a][k] - energy.damping_torque[a][k] - energy.resistance[a][k]) * w1;
        }
        elastic[k] = energy.elastic[k] - 0.5 * step * power;
        damping[k] += step * damped;
        friction[k] += energy.friction[k];
        turning[k] += energy.turning[k] + step * resisted;
        walls[k] += step * energy.given[k];
    }
}

} // namespace physics
