// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/finite_check.hpp"
#include "core/base/error.hpp"
#include "io/files/field_views.hpp"
#include "io/run/carried_fields.hpp"
#include <cmath>
#include <cstring>

namespace io {
namespace {

/// Whether all values are finite: anything else times zero is not zero.
bool all_finite(const double* values, int count)
{
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < count; ++i) sum += 0.0 * values[i];
    return sum == 0.0;
}

/// The cell of the first value that is not finite.
std::optional<core::Index3> bad_cell(core::View<const double> values)
{
    const core::Extents n = values.extents();
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            if (all_finite(values.row(j, k), n.ni)) continue;
            for (int i = 0; i < n.ni; ++i)
                if (!std::isfinite(values(i, j, k))) return core::Index3{i, j, k};
        }
    return std::nullopt;
}

std::string bad_field(World& world)
{
    std::string found;
    for_each_carried_field(world, [&](const auto& field) {
        const FieldViews<const double> all = views(field);
        for (core::LocalBlock b = 0; b < world.mesh().own_count() && found.empty(); ++b)
            for (const auto& array : all.blocks[std::size_t(b)])
                if (const auto c = bad_cell(array)) {
                    found = core::text("field '", all.name, "' is not finite in block ", world.mesh().global(b), ", cell (", c->i, ", ",
                                       c->j, ", ", c->k, ")");
                    break;
                }
    });
    return found;
}

std::string bad_grain(const World& world)
{
    if (!world.grains()) return "";
    const core::ParticleSet& p = world.grains()->particles;
    for (const auto* triple : {&p.position, &p.velocity, &p.spin})
        for (const core::Column& column : *triple) {
            if (all_finite(column.data(), p.owned)) continue;
            for (int g = 0; g < p.owned; ++g)
                if (!std::isfinite(column[std::size_t(g)])) return core::text("particle ", p.id[std::size_t(g)], " has no finite motion");
        }
    return "";
}

/// A grain that lies outside of the domain as a whole; soft walls let a part of it pass.
std::string lost_grain(const World& world)
{
    if (!world.grains()) return "";
    const core::ParticleSet& p = world.grains()->particles;
    const core::Domain& domain = world.grains()->domain();
    for (int g = 0; g < p.owned; ++g) {
        const core::Vec3 x = p.position_of(g);
        const double radius = p.radius[std::size_t(g)];
        for (int a = 0; a < 3; ++a)
            if (!domain.periodic[std::size_t(a)] && (x[a] < -radius || x[a] > domain.size[a] + radius))
                return core::text("particle ", p.id[std::size_t(g)], " has left the domain, to ", (x + domain.origin).transpose(),
                                  " m: contacts are too soft for its weight and speed, or sub-steps too long");
    }
    return "";
}

} // namespace

void require_finite(World& world)
{
    std::string found = bad_field(world);
    if (found.empty()) found = bad_grain(world);
    if (found.empty()) found = lost_grain(world);
    double any = found.empty() ? 0.0 : 1.0;
    world.ranks().max(std::span(&any, 1));
    if (any == 0.0) return;
    for (const auto& bytes : world.ranks().gather_all(std::as_bytes(std::span(found))))
        if (!bytes.empty())
            throw core::NumericsError(
                core::text(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), " at t = ", world.time(), " s"));
}

} // namespace io
