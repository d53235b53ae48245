// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/grain_places.hpp"
#include "core/base/error.hpp"
#include <algorithm>
#include <numeric>

namespace physics {
namespace {

core::NumericsError left_the_domain(const core::ParticleSet& grains, int g, const core::Vec3& x)
{
    return core::NumericsError(core::text("particle ", grains.id[std::size_t(g)], " at ", x.transpose(),
                                          " m lies in no cell of its rank: it has left the domain or moved too far in one step"));
}

} // namespace

void GrainPlaces::locate(const core::Mesh& mesh, const core::Locator& locator, const core::Domain& domain, const core::ParticleSet& grains)
{
    const auto count = std::size_t(grains.owned);
    locations_.resize(count);
    stencils_.resize(count);
    for (int g = 0; g < grains.owned; ++g) {
        core::Vec3 x = grains.position_of(g);
        for (int axis = 0; axis < 3; ++axis) x[axis] = domain.wrapped(axis, x[axis]);
        core::Location& last = last_[grains.id[std::size_t(g)]];
        const auto found = locator.find(x + domain.origin, last);
        const bool here = found && mesh.local(found->block) >= 0;
        if (!here) throw left_the_domain(grains, g, x + domain.origin);
        last = locations_[std::size_t(g)] = *found;
        stencils_[std::size_t(g)] = core::hat_stencil(mesh, *found);
    }
    sort_into_blocks(mesh, grains);
}

void GrainPlaces::sort_into_blocks(const core::Mesh& mesh, const core::ParticleSet& grains)
{
    order_.resize(std::size_t(grains.owned));
    std::iota(order_.begin(), order_.end(), 0);
    const auto key = [&](int g) { return std::pair(stencils_[std::size_t(g)].block, grains.id[std::size_t(g)]); };
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return key(a) < key(b); });
    first_.assign(std::size_t(mesh.own_count()) + 1, 0);
    for (const auto& s : stencils_) ++first_[std::size_t(s.block) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

GridSpread GrainPlaces::spread(int grain, const core::BlockGeometry& geometry) const
{
    const core::HatStencil& s = stencil(grain);
    const core::Index3 cell = location(grain).cell;
    GridSpread found;
    for (int axis = 0; axis < 3; ++axis) {
        const double width = geometry.volume(cell.i, cell.j, cell.k) / geometry.area(axis, cell.i, cell.j, cell.k).norm();
        const double part = s.part[std::size_t(axis)];
        found.cell += width * width / 3.0;
        found.hat += part * (1.0 - part) * width * width / 3.0;
    }
    return found;
}

void GrainPlaces::deposit(core::LocalBlock b, std::span<const double> quantity, core::View<double> field) const
{
    for (const int g : in_block(b)) core::deposit(stencil(g), quantity[std::size_t(g)], field);
}

void GrainPlaces::sample(core::LocalBlock b, std::span<const core::View<const double>> fields, std::span<std::vector<double>> columns) const
{
    std::array<std::ptrdiff_t, 8> at{};
    std::array<double, 8> weight{};
    for (const int g : in_block(b)) {
        std::size_t corner = 0;
        core::for_each_hat(stencil(g), [&](int i, int j, int k, double w) {
            at[corner] = fields[0].offset(i, j, k);
            weight[corner++] = w;
        });
        for (std::size_t f = 0; f < fields.size(); ++f) {
            double sum = 0;
            for (std::size_t c = 0; c < 8; ++c) sum += weight[c] * fields[f].at(at[c]);
            columns[f][std::size_t(g)] = sum;
        }
    }
}

void GrainPlaces::sample(core::LocalBlock b, core::View<const double> field, std::span<double> value) const
{
    for (const int g : in_block(b)) value[std::size_t(g)] = core::sample(stencil(g), field);
}

} // namespace physics
