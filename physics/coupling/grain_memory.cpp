// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// GrainExchange: what a grain remembers of its accelerations relative to the fluid (history_force.hpp).
#include "physics/coupling/grain_exchange.hpp"
#include "physics/coupling/grain_tables.hpp"
#include "physics/coupling/history_force.hpp"

namespace physics {
namespace {

constexpr int component_columns = 1 + HistoryTail::modes;
static_assert(history_columns == 3 * component_columns + 1);

/// One component of the memory of grain g, read from its columns or written to them.
template <class Grains, class Visit>
void visit_memory(Grains& grains, int first, int g, Visit visit)
{
    const auto column = [&](int n) -> auto& { return grains.columns[std::size_t(first + n)][std::size_t(g)]; };
    for (int m = 0; m < HistoryTail::modes; ++m) visit(column(1 + m), m);
}

HistoryMemory memory_of(const core::ParticleSet& grains, int first, int g)
{
    HistoryMemory memory;
    memory.last = grains.columns[std::size_t(first)][std::size_t(g)];
    visit_memory(grains, first, g, [&](const double& value, int m) { memory.mode[std::size_t(m)] = value; });
    return memory;
}

/// How memory decays in a step that begins with this slip.
HistoryTail tail_of(const CouplingParameters& p, double diameter, const core::Vec3& slip)
{
    const double diffusion = p.viscosity / p.fluid_density, viscous_time = diameter * diameter / diffusion;
    return HistoryTail(viscous_time, history_fading(slip.norm() * diameter / diffusion, viscous_time));
}

} // namespace

core::Vec3 GrainExchange::history(const core::ParticleSet& grains, int g, double dt) const
{
    const CouplingParameters& p = parameters_;
    const double diameter = 2.0 * grains.radius[std::size_t(g)];
    const HistoryTail tail = tail_of(p, diameter, column(grains, columns_.velocity_first, g) - grains.velocity_of(g));
    const double last = grains.columns[std::size_t(columns_.history + 3 * component_columns)][std::size_t(g)];
    core::Vec3 past;
    for (int a = 0; a < 3; ++a) past[a] = history_of(memory_of(grains, columns_.history + a * component_columns, g), tail, dt, last);
    return -history_factor(diameter, p.fluid_density, p.viscosity) * past;
}

void GrainExchange::remember(core::ParticleSet& grains, int g, double dt) const
{
    const core::Vec3 before = column(grains, columns_.velocity_before, g);
    const HistoryTail tail = tail_of(parameters_, 2.0 * grains.radius[std::size_t(g)], column(grains, columns_.velocity_first, g) - before);
    double& last = grains.columns[std::size_t(columns_.history + 3 * component_columns)][std::size_t(g)];
    const core::Vec3 relative = (grains.velocity_of(g) - before) / dt - column(grains, columns_.told, g);
    for (int a = 0; a < 3; ++a) {
        const int first = columns_.history + a * component_columns;
        const HistoryMemory after = remembered(memory_of(grains, first, g), tail, relative[a], dt, last);
        grains.columns[std::size_t(first)][std::size_t(g)] = after.last;
        visit_memory(grains, first, g, [&](double& value, int m) { value = after.mode[std::size_t(m)]; });
    }
    last = dt;
}

} // namespace physics
