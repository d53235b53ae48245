// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_results.hpp"
#include "io/files/mesh_nodes.hpp"
#include "io/files/row_order.hpp"

namespace io {
namespace {

/// Rows of three from three columns, for the owned particles.
std::vector<double> interleaved(const core::Triple& columns, int owned)
{
    std::vector<double> rows;
    for (std::size_t i = 0; i < std::size_t(owned); ++i)
        for (const core::Column& column : columns) rows.push_back(column[i]);
    return rows;
}

/// In the user's coordinates, periodic images brought into the domain.
std::vector<double> positions_of(const physics::ParticleDynamics& grains)
{
    std::vector<double> rows = interleaved(grains.particles.position, grains.particles.owned);
    const core::Domain& domain = grains.domain();
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n] = domain.origin[int(n % 3)] + domain.wrapped(int(n % 3), rows[n]);
    return rows;
}

} // namespace

WorldResults::WorldResults(const World& world, const std::string& directory)
{
    const bool measured = world.scene().measures(GrainMeasure::contacts) || world.scene().measures(GrainMeasure::motion);
    if (world.grains() && measured) grain_fields_.emplace(world);
    if (world.fluid() || grain_fields_) cells_.emplace(directory, world.ranks(), blocks_of(world.mesh()), nodes_of(world.mesh()));
    if (world.grains()) particles_.emplace(directory, world.ranks());
}

void WorldResults::write(World& world, std::int64_t number)
{
    const ResultTime when{int(number), world.time()};
    std::vector<FieldViews<const double>> fields;
    if (world.fluid()) {
        const physics::FluidState& state = world.fluid()->state();
        fields = {views(state.velocity), views(state.pressure)};
        if (const auto* turbulence = std::as_const(world).turbulence()) {
            fields.push_back(views(turbulence->k()));
            fields.push_back(views(turbulence->epsilon()));
        }
        if (world.scalars())
            for (const core::ScalarField& scalar : std::as_const(*world.scalars()).fields().values) fields.push_back(views(scalar));
        if (world.coupling()) fields.push_back(views(std::as_const(world.coupling()->fields().fraction)));
    }
    if (grain_fields_) {
        grain_fields_->find(world);
        for (const auto& view : grain_fields_->all()) fields.push_back(view);
    }
    if (cells_) (void)cells_->write(when, fields);
    if (particles_) write_particles(world, when);
}

void WorldResults::write_particles(const World& world, ResultTime when)
{
    const core::ParticleSet& p = world.grains()->particles;
    const auto owned = std::size_t(p.owned);
    std::vector<RowKey> keys;
    for (std::size_t i = 0; i < owned; ++i) keys.push_back({p.id[i], 0, 0});
    const RowOrder order(world.ranks(), keys);
    const auto sorted = [&](const std::vector<double>& column, int components) {
        return order.apply(std::span<const double>(column).first(owned * std::size_t(components)), components);
    };
    const auto positions = sorted(positions_of(*world.grains()), 3);
    const auto velocity = sorted(interleaved(p.velocity, p.owned), 3), spin = sorted(interleaved(p.spin, p.owned), 3);
    const auto radius = sorted(p.radius, 1);
    const auto ids = order.apply(std::span<const std::int64_t>(p.id).first(owned), 1);
    const std::vector<std::int64_t> kinds(p.species.begin(), p.species.begin() + p.owned);
    const auto species = order.apply(std::span<const std::int64_t>(kinds), 1);
    (void)particles_->write(when, {positions,
                                   {{"radius", 1, radius}, {"velocity", 3, velocity}, {"spin", 3, spin}},
                                   {{"species", 1, species}, {"id", 1, ids}},
                                   order.first_row(),
                                   order.total_rows()});
}

} // namespace io
