// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Metrics of what a scene measures of its grains.
#include "core/comm/reduce.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/grain_fields.hpp"
#include "io/run/metric_groups.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace io {
namespace {

/// Mean of a column of whole numbers.
double mean_contacts(World& world, int column)
{
    const core::ParticleSet& p = world.grains()->particles;
    const core::Column& contacts = p.columns[std::size_t(column)];
    std::array<std::int64_t, 2> sums{0, p.owned};
    for (int i = 0; i < p.owned; ++i) sums[0] += std::int64_t(contacts[std::size_t(i)]);
    world.ranks().sum(sums);
    return sums[1] > 0 ? double(sums[0]) / double(sums[1]) : 0.0;
}

double mean_coordination(World& world) { return mean_contacts(world, world.grains()->contact_columns()->coordination); }
double mean_wall_coordination(World& world) { return mean_contacts(world, world.grains()->contact_columns()->wall_coordination); }

double mean_temperature(World& world)
{
    GrainFields fields(world);
    fields.find(world);
    const auto sum = [&](auto term) {
        return core::sum_over_blocks(world.mesh(), world.ranks(), [&](core::LocalBlock b) {
            return physics::sum_cells(term, world.mesh().geometry(b).volume.view(), std::as_const(fields).fraction().on(b),
                                      std::as_const(fields).temperature().on(b));
        });
    };
    const double volume = sum([](double v, double fraction, double) { return v * fraction; });
    return volume > 0 ? sum([](double v, double fraction, double t) { return v * fraction * t; }) / volume : 0.0;
}

} // namespace

double lacey_index(const std::vector<std::array<std::int64_t, 2>>& cells)
{
    double all = 0, first = 0, squares = 0, filled = 0;
    for (const auto& [of_first, of_others] : cells) {
        const double count = double(of_first + of_others);
        if (count == 0) continue;
        all += count;
        first += double(of_first);
        squares += double(of_first) * double(of_first) / count;
        filled += 1;
    }
    if (all < 2) return 0.0;
    const double share = first / all, apart = share * (1 - share), chance = apart * (filled - 1) / (all - 1);
    const double variance = squares / all - share * share;
    return apart > chance ? (apart - variance) / (apart - chance) : 0.0;
}

MetricGroup measured_metrics(World& world)
{
    std::vector<std::string> names;
    std::vector<double (*)(World&)> values;
    const auto add = [&](GrainMeasure what, const char* name, double (*value)(World&)) {
        if (!world.scene().measures(what)) return;
        names.emplace_back(name);
        values.push_back(value);
    };
    add(GrainMeasure::contacts, "coordination", mean_coordination);
    add(GrainMeasure::contacts, "wall_coordination", mean_wall_coordination);
    add(GrainMeasure::motion, "granular_temperature", mean_temperature);
    add(GrainMeasure::mixing, "lacey_index", [](World& w) { return lacey_index(species_in_cells(w)); });
    return {names, [&world, values] {
                std::vector<double> row;
                for (auto* value : values) row.push_back(value(world));
                return row;
            }};
}

} // namespace io
