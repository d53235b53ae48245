// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/state_file.hpp"
#include "core/base/error.hpp"
#include "io/files/row_order.hpp"
#include "io/run/carried_fields.hpp"
#include "io/run/version.hpp"

namespace io {
namespace {

BlockList blocks_of(const core::Mesh& mesh) { return {mesh.own(), mesh.blocks()}; }

/// Calls visit(name, value) for every number of the clock; those of a prescribed flow only where there is one.
template <class Visit>
void for_each_scalar(World& world, Visit visit)
{
    physics::FluidClock& clock = world.clock();
    visit("time", clock.time);
    visit("time step before", clock.dt_before);
    visit("memory time", clock.memory_time);
    visit("step", clock.step);
    visit("steps since jump", clock.steps_since_jump);
    visit("drive sign", clock.drive.sign);
    visit("drive switched at", clock.drive.switched_at);
    if (world.traffic()) world.traffic()->for_each_number(visit);
    if (!world.fluid() || !world.fluid()->flow_control()) return;
    visit("drive expected", clock.drive.expected);
    visit("drive correction", clock.drive.correction);
    visit("drive resistance", clock.drive.resistance);
}

/// The columns of particles that are written, three at a time where they form vectors.
struct NamedColumns {
    std::string name;
    std::vector<core::Column*> columns;
};

std::vector<NamedColumns> columns_of(World& world)
{
    core::ParticleSet& p = world.grains()->particles;
    const auto three = [](core::Triple& t) { return std::vector<core::Column*>{&t[0], &t[1], &t[2]}; };
    std::vector<NamedColumns> all{{"position", three(p.position)},
                                  {"velocity", three(p.velocity)},
                                  {"spin", three(p.spin)},
                                  {"radius", {&p.radius}},
                                  {"mass", {&p.mass}},
                                  {"inertia", {&p.inertia}}};
    if (const auto* exchange = world.exchange()) {
        const auto& at = exchange->columns();
        const auto columns = [&p](int first, int count) {
            std::vector<core::Column*> found;
            for (int n = 0; n < count; ++n) found.push_back(&p.columns[std::size_t(first + n)]);
            return found;
        };
        all.push_back({"drag coefficient", columns(at.drag, 1)});
        if (at.extra_force >= 0) all.push_back({"extra force", columns(at.extra_force, 3)});
        if (at.wake >= 0) all.push_back({"own wake", columns(at.wake, 3)});
        if (at.fluctuation >= 0) all.push_back({"turbulence met", columns(at.fluctuation, 3)});
        if (at.history >= 0) all.push_back({"history of acceleration", columns(at.history, physics::history_columns)});
        all.push_back({"owed impulse", columns(at.owed, 3)});
        all.push_back({"told acceleration", columns(at.told, 3)});
        all.push_back({"hold", columns(at.hold, 1)});
        all.push_back({"drag before", columns(at.drag_before, 1)});
    }
    if (const auto& energy = world.grains()->energy(); energy.kept()) {
        const auto add = [&](const char* name, int column) { all.push_back({name, {&p.columns[std::size_t(column)]}}); };
        add("elastic energy", energy.elastic);
        add("energy damped", energy.damping);
        add("energy of friction", energy.friction);
        add("energy of turning", energy.turning);
        add("energy from walls", energy.walls);
    }
    return all;
}

std::vector<double> interleaved(const NamedColumns& c, int rows)
{
    std::vector<double> values;
    for (int row = 0; row < rows; ++row)
        for (const core::Column* column : c.columns) values.push_back((*column)[std::size_t(row)]);
    return values;
}

void save_particles(World& world, CheckpointWriter& writer)
{
    physics::ParticleDynamics& grains = *world.grains();
    grains.dissolve();
    const core::ParticleSet& p = grains.particles;
    std::vector<RowKey> keys;
    for (int i = 0; i < p.owned; ++i) keys.push_back({p.id[std::size_t(i)], 0, 0});
    const RowOrder order(world.ranks(), keys);
    const auto write = [&]<class T>(const std::string& name, const std::vector<T>& values, int components) {
        const auto sorted = order.apply(std::span<const T>(values), components);
        writer.rows("particles/" + name, std::span<const T>(sorted), components, order.first_row(), order.total_rows());
    };
    for (const NamedColumns& c : columns_of(world)) write(c.name, interleaved(c, p.owned), int(c.columns.size()));
    write("id", std::vector<std::int64_t>(p.id.begin(), p.id.begin() + p.owned), 1);
    write("species", std::vector<std::int64_t>(p.species.begin(), p.species.begin() + p.owned), 1);
}

void save_contacts(World& world, CheckpointWriter& writer)
{
    const physics::ParticleDynamics& grains = *world.grains();
    const core::ContactHistory& history = grains.history;
    std::vector<RowKey> keys;
    std::vector<std::int64_t> ids;
    std::vector<double> springs;
    for (int i = 0; i < grains.particles.owned; ++i)
        for (int k = history.start[std::size_t(i)]; k < history.start[std::size_t(i) + 1]; ++k) {
            const std::int64_t id = grains.particles.id[std::size_t(i)], other = history.other[std::size_t(k)];
            keys.push_back({id, other, 0});
            ids.insert(ids.end(), {id, other});
            for (int a = 0; a < history.width; ++a) springs.push_back(history.spring[std::size_t(history.width * k + a)]);
        }
    const RowOrder order(world.ranks(), keys);
    const auto sorted_ids = order.apply(std::span<const std::int64_t>(ids), 2);
    const auto sorted_springs = order.apply(std::span<const double>(springs), history.width);
    writer.rows("contacts/ids", std::span<const std::int64_t>(sorted_ids), 2, order.first_row(), order.total_rows());
    writer.rows("contacts/springs", std::span<const double>(sorted_springs), history.width, order.first_row(), order.total_rows());
}

/// Row numbers, in the checkpoint, of the particles that this rank shall own.
std::vector<std::size_t> rows_here(const std::vector<double>& position, World& world)
{
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < position.size() / 3; ++row) {
        const core::Vec3 x(position[3 * row], position[3 * row + 1], position[3 * row + 2]);
        if (world.owner_of(x) == world.ranks().rank()) rows.push_back(row);
    }
    return rows;
}

void load_contacts(const CheckpointReader& checkpoint, physics::ParticleDynamics& grains)
{
    const std::int64_t count = checkpoint.row_count("contacts/ids");
    const auto ids = checkpoint.rows<std::int64_t>("contacts/ids", 0, count);
    const auto springs = checkpoint.rows<double>("contacts/springs", 0, count);
    grains.history.clear();
    const int width = grains.history.width;
    std::size_t row = 0; // rows and particles are both in the order of ids
    for (int i = 0; i < grains.particles.owned; ++i) {
        const std::int64_t id = grains.particles.id[std::size_t(i)];
        while (row < std::size_t(count) && ids[2 * row] < id) ++row;
        for (; row < std::size_t(count) && ids[2 * row] == id; ++row) {
            core::Spring value{};
            for (int a = 0; a < width; ++a) value[std::size_t(a)] = springs[std::size_t(width) * row + std::size_t(a)];
            grains.history.add(ids[2 * row + 1], value);
        }
        grains.history.end_row();
    }
}

void load_particles(const CheckpointReader& checkpoint, World& world)
{
    physics::ParticleDynamics& grains = *world.grains();
    grains.dissolve();
    const std::int64_t count = checkpoint.row_count("particles/id");
    const auto rows = rows_here(checkpoint.rows<double>("particles/position", 0, count), world);
    core::ParticleSet& p = grains.particles;
    p.resize_owned(int(rows.size()));
    for (const NamedColumns& c : columns_of(world)) {
        const auto values = checkpoint.rows<double>("particles/" + c.name, 0, count);
        for (std::size_t n = 0; n < rows.size(); ++n)
            for (std::size_t a = 0; a < c.columns.size(); ++a) (*c.columns[a])[n] = values[rows[n] * c.columns.size() + a];
    }
    const auto ids = checkpoint.rows<std::int64_t>("particles/id", 0, count);
    const auto species = checkpoint.rows<std::int64_t>("particles/species", 0, count);
    for (std::size_t n = 0; n < rows.size(); ++n) {
        p.id[n] = ids[rows[n]];
        p.species[n] = std::int32_t(species[rows[n]]);
    }
    load_contacts(checkpoint, grains);
}

} // namespace

std::string save_state(World& world, const std::string& directory, int keep)
{
    CheckpointWriter writer(directory, world.clock().step, world.ranks());
    for_each_carried_field(world, [&](auto& field) { writer.field(views(std::as_const(field)), blocks_of(world.mesh())); });
    for_each_scalar(world, [&](const std::string& name, auto& value) { writer.scalar(name, double(value)); });
    if (world.grains()) {
        writer.scalar("settled_sub_steps", world.settled());
        save_particles(world, writer);
        save_contacts(world, writer);
    }
    writer.note("version", version_text());
    writer.note("scene", world.scene().name);
    return writer.finish(keep);
}

void load_state(const CheckpointReader& checkpoint, World& world)
{
    core::require<core::FileError>(
        checkpoint.note("scene") == world.scene().name,
        core::text("the checkpoint is of the scene '", checkpoint.note("scene"), "', not of '", world.scene().name, "'"));
    for_each_carried_field(world, [&](auto& field) { checkpoint.field(views(field), blocks_of(world.mesh())); });
    for_each_scalar(
        world, [&](const std::string& name, auto& value) { value = std::remove_reference_t<decltype(value)>(checkpoint.scalar(name)); });
    if (!world.grains()) return;
    world.settled() = checkpoint.scalar("settled_sub_steps");
    load_particles(checkpoint, world);
}

} // namespace io
