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

    /// Lists the owned particles and triangles that may touch when they have gone up to `skin` [m].
    void build(const core::ParticleSet& particles, double skin, const core::ContactHistory& history);
    /// Chooses among them those that may touch when they have gone up to `skin` [m].
    void refresh(const core::ParticleSet& particles, double skin, const core::Team& team);
    /// Appends the springs of owned particle i to the last row of `history`.
    void append_row(int i, core::ContactHistory& history) const;
    /// Adds the forces of the surface to those of `chunk` and moves the springs one step on. Contacts whose normals differ by
    /// less than 10 degrees are one, the deeper; a contact goes on with the spring of the last contact of similar normal.
    void add_forces(const core::ParticleSet& particles, const ContactLaws& laws, int chunk, ForceSums& sums);

private:
    /// What a contact keeps for the next step.
    struct Contact {
        int particle;
        core::Vec3 normal; ///< From the particle to the wall.
        core::Vec3 spring;
    };
    /// A contact of this step. @param normal_before  Half a step ago, both from the surface to the particle.
    struct Touch {
        int particle;
        SurfaceHit hit;
        core::Vec3 normal_before, spring;
    };
    /// Pairs of a particle and a triangle, in order of particles, then of triangles.
    struct Pairs {
        std::vector<int> particle, triangle;
        void add(int i, int t)
        {
            particle.push_back(i);
            triangle.push_back(t);
        }
        [[nodiscard]] int size() const { return int(particle.size()); }
    };
    struct Foot {
        PatchFoot now;
        double before_x, before_y, before_z; ///< The patch's normal half a step ago.
    };
    /// The particles of one chunk that are near the surface.
    struct Chunk {
        Pairs listed, near;
        std::vector<Foot> feet; ///< One for each near pair.
        std::vector<Touch> touches;
        std::vector<Contact> contacts;
    };
    void find_feet(const core::ParticleSet& particles, double half_step, Chunk& chunk) const;
    void find_touches(const core::ParticleSet& particles, Chunk& chunk) const;
    void touch_one(const core::Vec3& centre, double radius, int begin, int end, Chunk& chunk) const;

    WallSurface surface_;
    std::vector<Chunk> chunks_;
};

} // namespace physics
