// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Contact of particles with planes and cylinders.
#include "physics/particles/force_sums.hpp"

#include <variant>

namespace physics {

/// The half space behind a plane is solid. Positions of walls are relative to the domain's origin.
struct PlaneWall {
    core::Vec3 point = core::Vec3::Zero();   ///< [m]
    core::Vec3 normal = core::Vec3::UnitZ(); ///< Towards the particles; made a unit vector on entry.
};

/// The space outside an endless cylinder is solid.
struct CylinderWall {
    core::Vec3 point = core::Vec3::Zero(); ///< On the axis [m].
    core::Vec3 axis = core::Vec3::UnitX(); ///< Made a unit vector on entry.
    double radius = 1.0;                   ///< [m]
};

using Wall = std::variant<PlaneWall, CylinderWall>;

/// The particles near each wall and their tangential springs.
class WallContacts {
public:
    explicit WallContacts(std::vector<Wall> walls);
    /// Lists the owned particles with a gap below `skin` [m].
    void build(const core::ParticleSet& particles, double skin, const core::ContactHistory& history);
    /// Chooses among them those with a gap below `skin` [m], which are all that have forces.
    void refresh(const core::ParticleSet& particles, double skin, const core::Team& team);
    /// Puts the springs of those chosen back into the lists, before another choice and before append_row().
    void return_springs();
    /// Appends the springs of owned particle i to the last row of `history`.
    void append_row(int i, core::ContactHistory& history) const;
    /// Adds the forces of the walls to those of `chunk`, wall by wall, and moves the springs one step on.
    /// @param laws  One for each species, or one for all.
    void add_forces(const core::ParticleSet& particles, const ContactLaws& laws, int chunk, ForceSums& sums);
    [[nodiscard]] bool empty() const { return walls_.empty(); }

private:
    struct Contacts {
        std::vector<int> particle;
        std::vector<core::Column> spring;
    };
    /// Contacts of one wall, in order of the particles.
    struct List {
        Contacts all;
        std::vector<int> chunk_begin;
        Contacts near;          ///< Those of each chunk begin where all of it begin.
        std::vector<int> place; ///< Of near contacts among all.
        std::vector<int> near_end;
    };
    std::vector<Wall> walls_;
    std::vector<List> lists_;
};

} // namespace physics
