// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Contact of particles with planes and cylinders.
#include "physics/particles/motion_records.hpp"
#include "physics/particles/wall_frame.hpp"
#include "physics/particles/wall_sums.hpp"

#include <variant>

namespace physics {

/// The half space behind a plane is solid. Positions of walls are relative to the domain's origin.
struct PlaneWall {
    core::Vec3 point = core::Vec3::Zero();   ///< [m]
    core::Vec3 normal = core::Vec3::UnitZ(); ///< Towards the particles; made a unit vector on entry.
    WallMotion motion = {};
    int report = -1;  ///< Which of the loads its own is; none if negative.
    int material = 0; ///< Of ParticleParameters::walls.
};

enum class WallSide { inside, outside };

/// The space outside an endless cylinder is solid, or that inside.
struct CylinderWall {
    core::Vec3 point = core::Vec3::Zero(); ///< On the axis [m].
    core::Vec3 axis = core::Vec3::UnitX(); ///< Made a unit vector on entry.
    double radius = 1.0;                   ///< [m]
    WallSide particles = WallSide::inside;
    WallMotion motion = {};
    int report = -1;  ///< Which of the loads its own is; none if negative.
    int material = 0; ///< Of ParticleParameters::walls.
};

using Wall = std::variant<PlaneWall, CylinderWall>;

/// The particles near each wall and their tangential springs.
class WallContacts {
public:
    /// @param kinds  Of materials of walls x species, what contacts run in one loop: kinds_of() their laws.
    WallContacts(std::vector<Wall> walls, std::vector<int> kinds, int species);
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
    void add_forces(const MotionRecords::View& records, const ContactLaws& laws, int chunk, const WallSums& sums);
    [[nodiscard]] bool empty() const { return walls_.empty(); }

    void move_to(const WallTime& at);
    /// Greatest way that the surface of a wall has gone against particles in `box` since build() [m].
    [[nodiscard]] double way(const core::Bounds& box) const;
    /// The same since refresh() [m].
    [[nodiscard]] double near_way(const core::Bounds& box) const;

private:
    struct Contacts {
        std::vector<int> particle;
        std::vector<core::Column> spring;
    };
    /// Near contacts [begin, end) of one kind.
    struct Run {
        int begin, end, kind;
    };
    /// Contacts of one wall, in order of the particles.
    struct List {
        WallFrame frame;
        int report;
        int first_kind;  ///< Place of the wall's material among the kinds.
        bool same_shape; ///< The motion maps the wall onto itself: only its surface moves.
        Contacts all;
        std::vector<int> chunk_begin;
        Contacts near;                      ///< Those of each chunk begin where all of it begin.
        std::vector<int> place;             ///< Of near contacts among all.
        std::vector<std::vector<Run>> runs; ///< Of each chunk.
    };
    void choose(const core::ParticleSet& particles, List& list, int chunk, const std::vector<int>& near) const;
    template <class Act>
    void with_meeting(std::size_t wall, Act act) const;

    std::vector<Wall> walls_; ///< In their own frames.
    std::vector<List> lists_;
    std::vector<int> kinds_;
    int kind_count_;
};

} // namespace physics
