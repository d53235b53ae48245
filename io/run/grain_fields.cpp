// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/grain_fields.hpp"
#include "io/run/world.hpp"
#include <algorithm>
#include <numbers>
#include <numeric>

namespace io {
namespace {

constexpr std::array<const char*, 6> stress_names{"stress_xx", "stress_yy", "stress_zz", "stress_yz", "stress_zx", "stress_xy"};
constexpr std::array<std::array<int, 2>, 6> stress_axes{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};

core::ScalarField scalar(const core::Mesh& mesh, const char* name, const char* unit)
{
    return core::ScalarField({name, unit, 0}, mesh.own_cells());
}

} // namespace

/// Sums over the grains of a cell. Moments of velocities are taken against the velocity of the first grain, so that they lose no digits.
struct GrainFields::Cell {
    int count = 0;
    double volume = 0, mass = 0, contacts = 0, wall_contacts = 0;
    core::Vec3 first = core::Vec3::Zero(), momentum = core::Vec3::Zero();
    std::array<double, 6> squares{}, stress{};

    void add(const core::ParticleSet& p, std::size_t i, const physics::ContactColumns* columns)
    {
        const core::Vec3 v = p.velocity_of(int(i));
        if (count++ == 0) first = v;
        const core::Vec3 against = v - first;
        volume += 4.0 / 3.0 * std::numbers::pi * p.radius[i] * p.radius[i] * p.radius[i];
        mass += p.mass[i];
        momentum += p.mass[i] * against;
        for (std::size_t n = 0; n < 6; ++n) squares[n] += p.mass[i] * against[stress_axes[n][0]] * against[stress_axes[n][1]];
        if (columns == nullptr) return;
        contacts += p.columns[std::size_t(columns->coordination)][i];
        wall_contacts += p.columns[std::size_t(columns->wall_coordination)][i];
        for (std::size_t n = 0; n < 6; ++n) stress[n] += p.columns[std::size_t(columns->stress) + n][i];
    }

    /// Sum of mass x velocity x velocity against the mean [J].
    [[nodiscard]] double fluctuation(std::size_t n) const
    {
        return squares[n] - momentum[stress_axes[n][0]] * momentum[stress_axes[n][1]] / mass;
    }
};

GrainFields::GrainFields(const World& world)
    : fraction_(scalar(world.mesh(), "grain_fraction", "1")),
      velocity_({"grain_velocity", "m/s", 0}, world.mesh().own_cells()),
      temperature_(scalar(world.mesh(), "granular_temperature", "m2/s2"))
{
    fraction_.allocate();
    velocity_.allocate();
    temperature_.allocate();
    if (!world.grains()->contact_columns()) return;
    for (const char* name : {"coordination", "wall_coordination"}) contacts_.push_back(scalar(world.mesh(), name, "1"));
    for (const char* name : stress_names) stress_.push_back(scalar(world.mesh(), name, "Pa"));
    for (auto* fields : {&contacts_, &stress_})
        for (core::ScalarField& field : *fields) field.allocate();
}

void GrainFields::write(core::LocalBlock b, const core::Index3& c, const Cell& sums, double volume)
{
    const bool some = sums.count > 0;
    const core::Vec3 mean = some ? core::Vec3(sums.first + sums.momentum / sums.mass) : core::Vec3(core::Vec3::Zero());
    fraction_.on(b)[c] = sums.volume / volume;
    auto u = velocity_.on(b);
    u.x[c] = mean.x();
    u.y[c] = mean.y();
    u.z[c] = mean.z();
    const double trace = some ? sums.fluctuation(0) + sums.fluctuation(1) + sums.fluctuation(2) : 0.0;
    temperature_.on(b)[c] = some ? std::max(0.0, trace / (3.0 * sums.mass)) : 0.0;
    if (stress_.empty()) return;
    contacts_[0].on(b)[c] = some ? sums.contacts / sums.count : 0.0;
    contacts_[1].on(b)[c] = some ? sums.wall_contacts / sums.count : 0.0;
    for (std::size_t n = 0; n < 6; ++n) stress_[n].on(b)[c] = some ? (sums.stress[n] + sums.fluctuation(n)) / volume : 0.0;
}

std::vector<FieldViews<const double>> GrainFields::all() const
{
    std::vector<FieldViews<const double>> fields{views(fraction_), views(velocity_), views(temperature_)};
    for (const auto* more : {&contacts_, &stress_})
        for (const core::ScalarField& field : *more) fields.push_back(views(field));
    return fields;
}

std::vector<std::array<std::int64_t, 2>> species_in_cells(const World& world)
{
    const core::Mesh& mesh = world.mesh();
    std::vector<std::int64_t> first(std::size_t(mesh.blocks()) + 1, 0);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) first[std::size_t(mesh.global(b)) + 1] = mesh.geometry(b).cells.size();
    world.ranks().sum(first);
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int64_t> counts(2 * std::size_t(first.back()), 0);
    const core::ParticleSet& p = world.grains()->particles;
    for (int i = 0; i < p.owned; ++i) {
        const auto at = world.location_of(p.position_of(i));
        const core::LocalBlock b = at ? mesh.local(at->block) : -1;
        if (b < 0) continue;
        const core::Extents e = mesh.geometry(b).cells;
        const std::int64_t cell = first[std::size_t(at->block)] + (std::int64_t(at->cell.k) * e.nj + at->cell.j) * e.ni + at->cell.i;
        ++counts[2 * std::size_t(cell) + (p.species[std::size_t(i)] == 0 ? 0 : 1)];
    }
    world.ranks().sum(counts);
    std::vector<std::array<std::int64_t, 2>> cells(std::size_t(first.back()));
    for (std::size_t c = 0; c < cells.size(); ++c) cells[c] = {counts[2 * c], counts[2 * c + 1]};
    return cells;
}

void GrainFields::find(const World& world)
{
    const core::ParticleSet& p = world.grains()->particles;
    const auto& columns = world.grains()->contact_columns();
    std::vector<std::size_t> order(std::size_t(p.owned));
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id[a] < p.id[b]; });
    std::vector<std::vector<Cell>> cells(std::size_t(world.mesh().own_count()));
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
        cells[std::size_t(b)].resize(std::size_t(world.mesh().geometry(b).cells.size()));
    const auto place = [&](core::LocalBlock b, const core::Index3& c) -> Cell& {
        const core::Extents e = world.mesh().geometry(b).cells;
        return cells[std::size_t(b)][std::size_t((c.k * e.nj + c.j) * e.ni + c.i)];
    };
    for (const std::size_t i : order) {
        const auto location = world.location_of(p.position_of(int(i)));
        const core::LocalBlock b = location ? world.mesh().local(location->block) : -1;
        if (b >= 0) place(b, location->cell).add(p, i, columns ? &*columns : nullptr); // a soft wall lets centres slip out by rounding
    }
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b) {
        const auto volume = world.mesh().geometry(b).volume.view();
        core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
            write(b, {i, j, k}, place(b, {i, j, k}), volume(i, j, k));
        });
    }
}

} // namespace io
