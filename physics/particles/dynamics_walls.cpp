// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ParticleDynamics: walls on their way, and what they receive.
#include "physics/particles/dynamics.hpp"

#include <algorithm>

namespace physics {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

} // namespace

void ParticleDynamics::add_surface(WallSurface surface, const WallMotion& motion, int report)
{
    surfaces_.emplace_back(std::move(surface), motion,
                           SurfaceContacts::Place{int(surfaces_.size()), report, parameters_.species, parameters_.film.range});
}

int ParticleDynamics::surface_at(const core::Vec3& centre, double radius) const
{
    for (const SurfaceContacts& surface : surfaces_)
        if (surface.report() >= 0 && surface.touches(centre, radius)) return surface.report();
    return -1;
}

int ParticleDynamics::surface_around(const core::Vec3& centre) const
{
    for (const SurfaceContacts& surface : surfaces_)
        if (surface.excludes(centre)) return surface.report();
    return -1;
}

void ParticleDynamics::place_surfaces(double time)
{
    for (SurfaceContacts& surface : surfaces_) surface.move_to({time, 0.0});
}

void ParticleDynamics::begin(std::optional<double> time)
{
    begin_ = time;
    load_steps_ = 0;
    loads_.assign(loads_.size(), WallLoad{});
}

std::vector<WallLoad> ParticleDynamics::loads() const
{
    std::vector<WallLoad> sums(index_of(reports_));
    for (std::size_t n = 0; n < loads_.size(); ++n) sums[n % index_of(reports_)].add(loads_[n]);
    return sums;
}

void ParticleDynamics::move_walls(int sub_step)
{
    const WallTime at{begin_ ? std::optional(*begin_ + (sub_step + 0.5) * step_) : std::nullopt, 0.5 * step_};
    walls_.move_to(at);
    wall_way_ = walls_.way(extent_);
    near_wall_way_ = walls_.near_way(extent_);
    for (SurfaceContacts& surface : surfaces_) {
        surface.move_to(at);
        wall_way_ = std::max(wall_way_, surface.way(extent_));
        near_wall_way_ = std::max(near_wall_way_, surface.near_way(extent_));
    }
}

} // namespace physics
