// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/stress_probes.hpp"
#include "core/base/error.hpp"
#include "core/comm/reduce.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/metric_groups.hpp"
#include <algorithm>
#include <cmath>

namespace io {
namespace {

/// One column of a group. Collective.
double column(const MetricGroup& group, std::string_view name)
{
    const auto at = std::find(group.names.begin(), group.names.end(), name);
    return group.values()[std::size_t(at - group.names.begin())];
}

double largest_pressure(World& world)
{
    return core::max_over_blocks(world.mesh(), world.ranks(), [&](core::LocalBlock b) {
        const auto p = world.fluid()->state().pressure.on(b);
        double largest = 0;
        core::for_each_cell(world.mesh().geometry(b).cells,
                            [&](int i, int j, int k) { largest = std::max(largest, std::abs(p(i, j, k))); });
        return largest;
    });
}

/// Volume mean [m/s].
core::Vec3 mean_velocity(World& world)
{
    const core::Mesh& mesh = world.mesh();
    core::Vec3 mean;
    for (int axis = 0; axis < 3; ++axis)
        mean[axis] = core::sum_over_blocks(mesh, world.ranks(),
                                           [&](core::LocalBlock b) {
                                               const auto u = world.fluid()->state().velocity.on(b);
                                               const auto& component = axis == 0 ? u.x : axis == 1 ? u.y : u.z;
                                               double sum = 0;
                                               core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
                                                   sum += mesh.geometry(b).volume(i, j, k) * component(i, j, k);
                                               });
                                               return sum;
                                           }) /
                     mesh.total_volume();
    return mean;
}

/// Places of particles by their number, for a world on one rank [m].
std::map<std::int64_t, core::Vec3> places(World& world)
{
    std::map<std::int64_t, core::Vec3> result;
    const core::ParticleSet& p = world.grains()->particles;
    for (int i = 0; i < p.owned; ++i) result[p.id[std::size_t(i)]] = p.position_of(i);
    return result;
}

/// Distance from one of these places to the other's nearest image.
double distance(const World& world, core::Vec3 between)
{
    for (const core::Vec3& period : world.mesh().periods()) between -= std::round(between.dot(period) / period.squaredNorm()) * period;
    return between.norm();
}

/// Sums over the particles of all ranks: vx, vy, vz, |v|^2, count; and the largest |v|.
struct ParticleSums {
    std::array<double, 5> sums{};
    double largest = 0;
    [[nodiscard]] core::Vec3 mean_velocity() const { return core::Vec3(sums[0], sums[1], sums[2]) / std::max(1.0, sums[4]); }
};

ParticleSums particle_sums(World& world)
{
    ParticleSums result;
    const core::ParticleSet& p = world.grains()->particles;
    for (int i = 0; i < p.owned; ++i) {
        const core::Vec3 v = p.velocity_of(i);
        for (std::size_t a = 0; a < 3; ++a) result.sums[a] += v[int(a)];
        result.sums[3] += v.squaredNorm();
        result.sums[4] += 1;
        result.largest = std::max(result.largest, v.norm());
    }
    world.ranks().sum(result.sums);
    world.ranks().max(std::span(&result.largest, 1));
    return result;
}

} // namespace

StressProbes::StressProbes(World& world, const StressCriteria& criteria) : world_(world), criteria_(criteria)
{
    if (world.coupling()) ledger_.emplace(world);
    if (world.fluid()) add_fluid();
    if (world.grains()) add_particles();
    if (world.coupling()) add_coupling();
    if (criteria.of(Measure::energy))
        during_.push_back({Measure::energy, [this] {
                               const double fluid = world_.fluid() ? column(fluid_metrics(world_), "fluid_kinetic_energy") : 0.0;
                               return fluid + (world_.grains() ? column(particle_metrics(world_), "particle_kinetic_energy") : 0.0);
                           }});
    for (std::size_t m = 0; m < measures.size(); ++m) {
        const auto is_m = [&](const Probe& p) { return p.measure == Measure(m); };
        const bool measured = std::any_of(during_.begin(), during_.end(), is_m) || std::any_of(final_.begin(), final_.end(), is_m);
        core::require<core::ConfigError>(!criteria.bounds[m] || measured || StressCriteria::of_the_end(Measure(m)),
                                         core::text("criteria.", measures[m].word, " has no meaning for this scene"));
    }
}

void StressProbes::add_during(Measure m, std::function<double()> value)
{
    if (criteria_.of(m)) during_.push_back({m, std::move(value)});
}

void StressProbes::add_final(Measure m, std::function<double()> value)
{
    if (criteria_.of(m)) final_.push_back({m, std::move(value)});
}

void StressProbes::add_fluid()
{
    add_during(Measure::fluid_speed, [this] { return column(fluid_metrics(world_), "largest_speed"); });
    if (criteria_.of(Measure::pressure) || criteria_.of(Measure::pressure_growth))
        during_.push_back({Measure::pressure, [this] { return largest_pressure(world_); }});
    if (world_.scene().fluid->drive)
        add_final(Measure::flow_speed, [this] {
            const core::Vec3 along = physics::drive_direction(world_.fluid()->parameters().drive).cwiseAbs();
            const Grid& grid = world_.scene().grid;
            const double section = grid.volume() / along.dot(grid.high() - grid.low());
            return column(drive_metrics(world_), "flow_rate") / section;
        });
}

void StressProbes::add_particles()
{
    add_during(Measure::particle_speed, [this] { return particle_sums(world_).largest; });
    add_final(Measure::final_particle_speed, [this] { return particle_sums(world_).largest; });
    add_final(Measure::final_rms_speed, [this] {
        const auto sums = particle_sums(world_).sums;
        return sums[4] > 0 ? std::sqrt(sums[3] / sums[4]) : 0.0;
    });
    add_final(Measure::settling_speed, [this] {
        const core::Vec3 fluid = world_.fluid() ? mean_velocity(world_) : core::Vec3(core::Vec3::Zero());
        return (particle_sums(world_).mean_velocity() - fluid).dot(gravity_of(world_.scene()).normalized());
    });
    add_final(Measure::creep, [this] {
        double largest = 0;
        for (const auto& [id, place] : places(world_)) largest = std::max(largest, distance(world_, place - first_places_.at(id)));
        return largest;
    });
}

void StressProbes::add_coupling()
{
    add_during(Measure::slip_speed, [this] { return (particle_sums(world_).mean_velocity() - mean_velocity(world_)).norm(); });
    add_during(Measure::solid_fraction, [this] {
        return core::max_over_blocks(world_.mesh(), world_.ranks(), [&](core::LocalBlock b) {
            const auto phi = world_.coupling()->fields().fraction.on(b);
            double largest = 0;
            core::for_each_cell(world_.mesh().geometry(b).cells,
                                [&](int i, int j, int k) { largest = std::max(largest, 1.0 - phi(i, j, k)); });
            return largest;
        });
    });
    add_during(Measure::momentum_defect, [this] { return ledger_->defect(); });
    add_during(Measure::exchange_defect, [this] { return ledger_->exchange_defect(); });
    add_final(Measure::ledger, [this] { return ledger_->totals().ledger.norm() + ledger_->totals().owed.norm(); });
}

void StressProbes::after_step()
{
    const bool books = criteria_.of(Measure::momentum_defect) || criteria_.of(Measure::exchange_defect) || criteria_.of(Measure::ledger);
    if (ledger_ && books) ledger_->update();
    if (criteria_.of(Measure::creep) && first_places_.empty()) first_places_ = places(world_);
    for (const Probe& probe : during_) {
        double& largest = values_[std::size_t(probe.measure)];
        const double now = probe.value();
        largest = std::isfinite(now) ? std::max(largest, now) : now;
        core::require<core::NumericsError>(
            std::isfinite(now), core::text(measures[std::size_t(probe.measure)].word, " is no number after step ", world_.clock().step));
    }
}

void StressProbes::finish()
{
    for (const Probe& probe : final_) values_[std::size_t(probe.measure)] = probe.value();
}

} // namespace io
