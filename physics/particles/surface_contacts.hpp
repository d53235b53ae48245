// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Contacts of particles with a wall surface: one for each place of contact, its friction carried from face to face.
#include "physics/particles/force_sums.hpp"
#include "physics/particles/wall_surface.hpp"

namespace physics {

class SurfaceContacts {
public:
    SurfaceContacts() = default;
    explicit SurfaceContacts(WallSurface surface) : surface_(std::move(surface)) {}
    [[nodiscard]] bool empty() const { return surface_.empty(); }

    /// Lists the owned particles with a gap below `skin` [m] and the triangles near each.
    void build(const core::ParticleSet& particles, double skin, const core::ContactHistory& history);
    /// Chooses among them the triangles with a gap below `skin` [m].
    void refresh(const core::ParticleSet& particles, double skin, const core::Team& team);
    /// Appends the springs of owned particle i to the last row of `history`.
    void append_row(int i, core::ContactHistory& history) const;
    /// Adds the forces of the surface to those of `chunk` and moves the springs one step on. Contacts whose normals differ by
    /// less than 10 degrees are one, the deeper; a contact goes on with the spring of the last contact of similar normal.
    void add_forces(const core::ParticleSet& particles, const ContactLaws& laws, int chunk, ForceSums& sums);

private:
    struct Contact {
        core::Vec3 normal = core::Vec3::Zero(); ///< From the particle to the wall; zero just after a rebuild.
        core::Vec3 spring = core::Vec3::Zero();
    };
    /// One particle near the surface.
    struct Neighbour {
        int particle = 0;
        int begin = 0, end = 0, near_end = 0; ///< Its triangles in triangles_ and near_.
        std::vector<Contact> contacts;
    };
    void find_hits(const core::Vec3& centre, double radius, const Neighbour& neighbour, std::vector<SurfaceHit>& hits) const;
    [[nodiscard]] static core::Vec3 take_spring(std::vector<Contact>& old, const core::Vec3& normal);

    WallSurface surface_;
    std::vector<Neighbour> neighbours_; // in order of the particles
    std::vector<int> chunk_begin_;
    std::vector<int> triangles_, near_;
};

} // namespace physics
