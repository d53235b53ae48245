// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// GrainExchange: turbulence that grains meet (dispersion.hpp), and what they set against it.
#include "core/base/random.hpp"
#include "physics/coupling/dispersion.hpp"
#include "physics/coupling/grain_exchange.hpp"
#include "physics/coupling/grain_tables.hpp"

namespace physics {

using grain_tables::at, grain_tables::put;

void GrainExchange::stir(core::ParticleSet& grains, const GrainTable& views, const GrainTable& turbulence, const GrainStirring& step) const
{
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const double deviation = turbulence[seen_deviation][k];
        const core::Vec3 before = column(grains, columns_.fluctuation, g);
        core::Vec3 after = before, mean = core::Vec3::Zero();
        if (deviation > 0.0) {
            const core::Vec3 slip = at(views, view_velocity, g) + deviation * before - grains.velocity_of(g);
            const SeenTurbulence seen{deviation, at(turbulence, seen_growth, g), turbulence[seen_rate][k]};
            const double rate = crossing_rate(seen, slip.norm());
            const auto draws = [&, id = grains.id[k]](std::uint64_t n) {
                return core::random_normal(parameters_.random_seed, id, 2 * step.number + n);
            };
            const auto ends = draws(0), means = draws(1);
            for (int a = 0; a < 3; ++a) {
                const auto found = fluctuate(before[a], seen.growth[a], rate, step.dt, {ends[std::size_t(a)], means[std::size_t(a)]});
                after[a] = found.at_end;
                mean[a] = deviation * found.mean;
            }
        }
        put(grains, columns_.fluctuation, g, after);
        put(grains, columns_.fluctuation_met, g, mean);
    }
}

void GrainExchange::add_fluctuations(const core::ParticleSet& grains, GrainTable& views) const
{
    if (columns_.fluctuation < 0) return;
    for (int g = 0; g < grains.owned; ++g)
        for (int a = 0; a < 3; ++a)
            views[view_velocity + std::size_t(a)][std::size_t(g)] +=
                grains.columns[std::size_t(columns_.fluctuation_met + a)][std::size_t(g)];
}

GrainTable GrainExchange::resistance(const core::ParticleSet& grains) const
{
    const auto owned = std::size_t(grains.owned);
    const auto first_of = [&](const core::Column& column) { return std::vector<double>(column.begin(), column.begin() + grains.owned); };
    GrainTable table(resisting);
    table[resisting_drag] = first_of(grains.columns[std::size_t(columns_.drag)]);
    table[resisting_mass] = first_of(grains.columns[std::size_t(columns_.added_mass)]);
    for (std::size_t g = 0; g < owned; ++g) table[resisting_mass][g] += grains.mass[g];
    return table;
}

} // namespace physics
