// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of scenes that a turn carries onto themselves: so it must be with all that is in them.
#include "io/scene/scene_reader.hpp"
#include <fmt/format.h>

namespace io {
namespace {

constexpr double slight = 1e-9; // sine of an angle, and round-off of lengths

void check_boundary(const Boundary& boundary, const TurnKeys& turn, const std::string& path, const Locations& locations, Problems& problems)
{
    if (const auto& velocity = boundary.velocity; velocity && turn.axis.cross(*velocity).norm() > slight * velocity->norm())
        problems.add(locations.at(path + ".velocity"), "after the turn of the grid this velocity points another way",
                     "keep what lies along the axis; a round wall turns by 'spin', other velocities by place are a 'profile_file'");
    if (const auto& spin = boundary.spin) {
        const core::Vec3 between = spin->point - turn.point;
        if (turn.axis.cross(spin->axis).norm() > slight || turn.axis.cross(between).norm() > slight * (1 + between.norm()))
            problems.add(locations.at(path + ".spin"), "the wall spins about another axis than that of the turn of the grid",
                         "give it the axis and the point of grid.turn");
    }
}

} // namespace

void check_turn(const Scene& scene, const Locations& locations, Problems& problems)
{
    if (!locations.good("grid.turn")) return;
    if (!scene.particles.empty())
        problems.add(locations.at("grid.turn"), "particles cannot pass sides that are joined by a turn yet",
                     "leave the particles out, or make a grid of the whole ring");
    if (!scene.fluid) return;
    for (std::size_t n = 0; n < scene.fluid->boundaries.size(); ++n) {
        const std::string path = fmt::format("fluid.boundaries.{}", n);
        if (locations.good(path)) check_boundary(scene.fluid->boundaries[n], *scene.grid.turn, path, locations, problems);
    }
}

} // namespace io
