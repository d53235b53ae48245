// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What holds on the boundaries of the domain, as said by the scene and as each block needs it.
#include "core/grid/mesh.hpp"
#include "physics/fluid/boundary_kind.hpp"
#include "physics/fluid/side_vectors.hpp"
#include "physics/fluid/time_course.hpp"
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace physics {

/// A boundary as the scene says it; a wall at rest unless something else is said.
struct BoundaryCondition {
    BoundaryKind kind = BoundaryKind::wall;
    core::Vec3 velocity = core::Vec3::Zero();                       ///< of a wall or an inflow [m/s]
    std::function<core::Vec3(const core::Vec3&)> profile = nullptr; ///< of wall or inflow by place [m/s]; instead of `velocity`
    bool laminar = false;                                           ///< an inflow distributed by laminar_shape(), its mean `velocity`
    TimeCourse course = SteadyCourse{};                             ///< factor of the velocity of wall or inflow
    double pressure = 0;                                            ///< where it is given, without that of the drive [Pa]
};

/// By boundary name; boundaries that are not named are walls at rest.
using BoundaryConditions = std::map<std::string, BoundaryCondition>;

/// One side of a block.
struct BlockSide {
    std::optional<BoundaryKind> kind;   ///< none: another block lies beyond
    SideVectors velocity;               ///< of wall or inflow on each face [m/s]
    SideVectors normal;                 ///< outward, of unit length; where walls hold the fluid it is not needed and zero
    double pressure = 0;                ///< where it is given [Pa]
    TimeCourse course = SteadyCourse{}; ///< factor of the velocity that the scene gives

    [[nodiscard]] bool varies() const { return !std::holds_alternative<SteadyCourse>(course); }
    [[nodiscard]] bool slips() const { return kind && physics::slips(*kind); }
    [[nodiscard]] bool gives_pressure() const { return kind && physics::gives_pressure(*kind); }
    /// Is the flux through it known?
    [[nodiscard]] bool gives_flux() const { return kind && !gives_pressure(); }
};

/// The sides of one block.
struct BlockWalls {
    std::array<BlockSide, 6> sides;
    /// Least-squares gradients in which sides that give the pressure, or its gradient, take part; none if there are no such sides.
    std::optional<core::GradientMatrices> pressure_matrices;

    [[nodiscard]] const BlockSide& at(core::Side s) const { return sides[std::size_t(s)]; }
};

/// One entry for each block of this rank.
/// @throws ConfigError for a name that no boundary has.
[[nodiscard]] std::vector<BlockWalls> make_walls(const core::Mesh& mesh, const BoundaryConditions& conditions);

/// Gives the boundaries that change in time the velocity that they have at one.
/// @param full   As the scene gives them.
/// @param walls  Of the same sides.
void set_time(const std::vector<BlockWalls>& full, double time, std::vector<BlockWalls>& walls);

/// Is any boundary of the domain, on whatever rank, of a kind that the test holds for?
template <class Test>
[[nodiscard]] bool any_boundary(const core::Mesh& mesh, const BoundaryConditions& conditions, Test holds)
{
    const auto& all = mesh.topology().boundaries;
    return std::any_of(all.begin(), all.end(), [&](const core::Boundary& boundary) {
        const auto said = conditions.find(boundary.name);
        return holds(said == conditions.end() ? BoundaryKind::wall : said->second.kind);
    });
}

/// Fluxes through the sides of a block that are given [m3/s].
struct GivenFlux {
    double net = 0;     ///< outward
    double largest = 0; ///< if all velocities stood at right angles to the sides: what round-off refers to
};
[[nodiscard]] GivenFlux given_flux(const core::BlockGeometry& geometry, const BlockWalls& walls);

/// For the gradient of a pressure whose halo mirror_pressure() has filled.
[[nodiscard]] const core::GradientMatrices& pressure_matrices(const core::BlockGeometry& geometry, const BlockWalls& walls);

} // namespace physics
