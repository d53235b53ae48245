// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_metrics.hpp"
#include "io/files/rank_zero.hpp"
#include "io/run/bed_metrics.hpp"
#include "io/run/metric_groups.hpp"

namespace io {

std::vector<MetricGroup> state_metrics(World& world)
{
    std::vector<MetricGroup> groups;
    if (world.fluid()) groups.push_back(fluid_metrics(world));
    if (world.fluid() && world.scene().fluid->drive) groups.push_back(drive_metrics(world));
    if (world.turbulence()) groups.push_back(turbulence_metrics(world));
    if (world.scalars()) groups.push_back(scalar_metrics(world));
    if (world.grains()) groups.push_back(particle_metrics(world));
    if (world.grains() && world.grains()->energy().kept()) groups.push_back(energy_metrics(world));
    if (world.traffic() && world.traffic()->is_open()) groups.push_back(traffic_metrics(world));
    if (world.grains() && !world.scene().walls.empty()) groups.push_back(wall_metrics(world));
    if (world.grains() && !world.scene().output.grains.empty()) groups.push_back(measured_metrics(world));
    if (world.grains() && world.scene().gravity) groups.push_back(height_metrics(world));
    if (world.grains() && world.scene().measures(GrainMeasure::transport)) groups.push_back(bed_metrics(world));
    if (world.grains() && world.scene().measures(GrainMeasure::segregation)) groups.push_back(segregation_metrics(world));
    if (world.coupling()) groups.push_back(solid_metrics(world));
    return groups;
}

std::vector<double> values_of(const std::vector<MetricGroup>& groups)
{
    std::vector<double> all;
    for (const MetricGroup& group : groups) {
        const auto values = group.values();
        all.insert(all.end(), values.begin(), values.end());
    }
    return all;
}

WorldMetrics::WorldMetrics(World& world, const std::filesystem::path& file, std::optional<double> restart_time) : ranks_(world.ranks())
{
    if (world.coupling()) ledger_.emplace(world);
    if (world.one_way()) one_way_.emplace(world);
    groups_.push_back(step_metrics(world));
    for (MetricGroup& group : state_metrics(world)) groups_.push_back(std::move(group));
    if (ledger_) groups_.push_back(momentum_metrics(*ledger_));
    if (one_way_) groups_.push_back(one_way_metrics(*one_way_));
    if (ledger_ && world.scene().measures(GrainMeasure::transport)) groups_.push_back(bed_stress_metrics(world, *ledger_));
    on_rank_zero<core::FileError>(ranks_, [&] { writer_.emplace(file, names(), restart_time); });
}

void WorldMetrics::after_step()
{
    if (ledger_) ledger_->update();
    if (one_way_) one_way_->update();
}

std::vector<std::string> WorldMetrics::names() const
{
    std::vector<std::string> all;
    for (const MetricGroup& group : groups_) all.insert(all.end(), group.names.begin(), group.names.end());
    return all;
}

std::vector<double> WorldMetrics::row() const { return values_of(groups_); }

void WorldMetrics::write()
{
    const auto values = row();
    if (writer_) writer_->add(values);
}

void WorldMetrics::flush()
{
    if (writer_) writer_->flush();
}

} // namespace io
