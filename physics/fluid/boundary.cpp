// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/boundary.hpp"
#include "core/base/error.hpp"
#include "core/grid/gradient_matrices.hpp"
#include "core/grid/hexahedron.hpp"
#include "physics/fluid/flow_shape.hpp"
#include "physics/fluid/side_faces.hpp"
#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using Profile = std::function<core::Vec3(const core::Vec3&)>;

BlockSide make_side(const core::Mesh& mesh, const core::Boundary& boundary, const BoundaryCondition& condition, const Profile& profile)
{
    const core::LocalBlock b = mesh.local(boundary.block);
    const auto& geometry = mesh.geometry(b);
    BlockSide side{condition.kind, SideVectors(condition.velocity), SideVectors(), condition.pressure, condition.course};
    if (profile)
        side.velocity = {geometry.cells, boundary.side, [&](core::Index3 face) {
                             const auto corners = core::face_corners(mesh.vertices(boundary.block), core::axis_of(boundary.side), face);
                             return profile(core::face_shape(corners).centre);
                         }};
    if (slips(condition.kind) || condition.kind == BoundaryKind::outflow)
        side.normal = {geometry.cells, boundary.side, [&](core::Index3 face) -> core::Vec3 {
                           const core::Vec3 area = geometry.area(core::axis_of(boundary.side), face.i, face.j, face.k);
                           return (core::is_high(boundary.side) ? area : core::Vec3(-area)).normalized();
                       }};
    return side;
}

std::optional<core::GradientMatrices> matrices_with_given_pressure(const core::BlockGeometry& geometry, const BlockWalls& walls)
{
    const auto takes_part = [](const BlockSide& s) { return s.gives_pressure() || s.kind == BoundaryKind::symmetry; };
    if (std::none_of(walls.sides.begin(), walls.sides.end(), takes_part)) return std::nullopt;
    std::array<bool, 6> part{};
    for (const core::Side s : core::all_sides) part[std::size_t(s)] = !walls.at(s).kind || takes_part(walls.at(s));
    return core::gradient_matrices(geometry, part);
}

/// By place, of each boundary that does not have one velocity.
std::map<std::string, Profile> profiles(const core::Mesh& mesh, const BoundaryConditions& conditions)
{
    const auto is_wall = [&](const std::string& name) {
        const auto said = conditions.find(name);
        return said == conditions.end() || said->second.kind == BoundaryKind::wall;
    };
    std::map<std::string, Profile> all;
    for (const auto& [name, condition] : conditions) {
        all[name] = condition.profile;
        if (condition.laminar)
            all[name] = [shape = laminar_shape(mesh, name, is_wall), mean = condition.velocity](const core::Vec3& x) -> core::Vec3 {
                return shape(x) * mean;
            };
    }
    return all;
}

} // namespace

void set_time(const std::vector<BlockWalls>& full, double time, std::vector<BlockWalls>& walls)
{
    for (std::size_t b = 0; b < full.size(); ++b)
        for (const core::Side s : core::all_sides)
            if (const BlockSide& side = full[b].at(s); side.varies())
                walls[b].sides[std::size_t(s)].velocity = side.velocity.scaled(value_at(side.course, time));
}

std::vector<BlockWalls> make_walls(const core::Mesh& mesh, const BoundaryConditions& conditions)
{
    std::vector<BlockWalls> walls(std::size_t(mesh.own_count()));
    BoundaryConditions unused = conditions;
    std::map<std::string, Profile> by_place = profiles(mesh, conditions);
    for (const core::Boundary& boundary : mesh.topology().boundaries) {
        const auto said = conditions.find(boundary.name);
        unused.erase(boundary.name);
        if (const core::LocalBlock b = mesh.local(boundary.block); b >= 0)
            walls[std::size_t(b)].sides[std::size_t(boundary.side)] =
                make_side(mesh, boundary, said != conditions.end() ? said->second : BoundaryCondition{}, by_place[boundary.name]);
    }
    core::require<core::ConfigError>(unused.empty(),
                                     core::text("no boundary is called '", unused.empty() ? "" : unused.begin()->first, "'"));
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        walls[std::size_t(b)].pressure_matrices = matrices_with_given_pressure(mesh.geometry(b), walls[std::size_t(b)]);
    return walls;
}

GivenFlux given_flux(const core::BlockGeometry& geometry, const BlockWalls& walls)
{
    GivenFlux sum;
    for (const core::Side side : core::all_sides) {
        if (!walls.at(side).gives_flux()) continue;
        for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
            const core::Vec3 area = geometry.area(core::axis_of(side), i, j, k), velocity = walls.at(side).velocity[{i, j, k}];
            const double flux = area.dot(velocity);
            sum.net += core::is_high(side) ? flux : -flux;
            sum.largest += area.norm() * velocity.norm();
        });
    }
    return sum;
}

const core::GradientMatrices& pressure_matrices(const core::BlockGeometry& geometry, const BlockWalls& walls)
{
    return walls.pressure_matrices ? *walls.pressure_matrices : geometry.gradient;
}

} // namespace physics
