// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Contacts of particles with a wall surface: one for each place of contact, its friction carried from face to face.
#include "physics/particles/surface_filter.hpp"
#include "physics/particles/surface_side.hpp"
#include "physics/particles/surface_touches.hpp"

namespace physics {

class SurfaceContacts {
public:
    /// What a surface is among the others.
    struct Place {
        int number;   ///< Of the surface among all.
        int report;   ///< Which of the loads its own is; none if negative.
        int species;  ///< Of particles, whose laws each material of a wall has.
        double reach; ///< Gap up to which there are forces [m].
    };
    SurfaceContacts(WallSurface surface, const WallMotion& motion, const Place& place)
        : surface_(std::move(surface)), frame_(motion), place_(place)
    {
    }

    [[nodiscard]] int report() const { return place_.report; }
    /// Says on which side of the closed surface particles are.
    void set_side(SurfaceSide side) { side_.emplace(std::move(side)); }
    /// Whether a sphere touches the surface where it is now.
    [[nodiscard]] bool touches(const core::Vec3& centre, double radius) const;
    /// Whether particles are not on this side of the surface where it is now.
    [[nodiscard]] bool excludes(const core::Vec3& centre) const { return side_ && !side_->holds(own(centre)); }
    void move_to(const WallTime& at) { frame_.move_to(at); }
    /// Greatest way that the surface has gone against particles in `box` since build() [m].
    [[nodiscard]] double way(const core::Bounds& box) const { return frame_.way(box); }
    /// The same since refresh() [m].
    [[nodiscard]] double near_way(const core::Bounds& box) const { return frame_.near_way(box); }

    /// Lists the owned particles and triangles that may touch when they have gone up to `skin` [m].
    /// @param near_skin  The same for refresh() [m].
    void build(const core::ParticleSet& particles, double skin, double near_skin, const core::ContactHistory& history);
    /// Chooses among them those that may touch when they have gone up to the near skin.
    void refresh(const core::ParticleSet& particles, const core::Team& team);
    /// Appends the springs of owned particle i to the last row of `history`.
    void append_row(int i, core::ContactHistory& history) const;
    /// Adds the forces of the surface to those of `chunk` and moves the springs one step on. Contacts whose normals differ by
    /// less than 10 degrees are one, the deeper; a contact goes on with the spring of the last contact of similar normal.
    void add_forces(const core::ParticleSet& particles, const ContactLaws& laws, int chunk, const WallSums& sums);

private:
    /// What a contact keeps for the next step.
    struct Contact {
        int particle;
        core::Vec3 normal; ///< From the particle to the wall.
        core::Vec3 spring;
    };
    /// A contact of this step; the surface's normal half a step ago, from the surface to the particle, and its material.
    struct Touch {
        SurfaceHit hit;
        core::Vec3 before;
        int material;
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
        /// Particles of pairs begin..begin + 3; beyond the last pair the last once more.
        [[nodiscard]] std::array<int, 4> particles_from(int begin) const { return four(particle, begin); }
        [[nodiscard]] std::array<int, 4> triangles_from(int begin) const { return four(triangle, begin); }
        static std::array<int, 4> four(const std::vector<int>& column, int begin)
        {
            std::array<int, 4> values;
            for (std::size_t k = 0; k < 4; ++k) values[k] = column[std::min(std::size_t(begin) + k, column.size() - 1)];
            return values;
        }
    };
    /// Of four near pairs.
    struct Feet {
        PatchFoot<core::Four> now;
        core::Four before_x, before_y, before_z; ///< The patch's normal half a step ago.
        core::Four inside;                       ///< Least of the three coordinates on the triangle.
    };
    /// The particles of one chunk that are near the surface.
    struct Chunk {
        Pairs listed, near;
        std::vector<SurfaceFilter> filters; ///< Of the listed pairs, four at a time.
        std::vector<FourPatches> patches;   ///< Of the near pairs, four at a time.
        std::vector<char> plain;            ///< Near pairs whose triangle has no sharp edge and no sharp corner.
        std::vector<Feet> feet;
        std::vector<Touch> touches; ///< Of one particle.
        std::vector<Contact> contacts, contacts_before;
        std::vector<core::Vec3> turns, turns_before; ///< Of the contacts, in scenes whose contacts resist turning.
    };
    void gather_patches(Chunk& chunk) const;
    [[nodiscard]] FourPatches patches_of(const Pairs& pairs, int begin) const;
    void find_feet(const core::ParticleSet& particles, double half_step, Chunk& chunk) const;
    [[nodiscard]] Touch touch_of(const Chunk& chunk, int pair) const;
    void add_near_touches(const core::Vec3& centre, double radius, int begin, int end, Chunk& chunk) const;
    static void drop_touches_behind(std::vector<Touch>& touches);
    void find_touches(const core::Vec3& centre, double radius, int begin, int end, Chunk& chunk) const;
    /// The springs of the contact among [first, last) of contacts_before of the most similar normal, which is spent; zero if there is none.
    [[nodiscard]] static core::Spring take_spring(Chunk& chunk, std::ptrdiff_t first, std::ptrdiff_t last, const core::Vec3& normal);
    void finish(const core::ParticleSet& particles, const ContactLaws& laws, SurfaceTouches& block, Chunk& chunk,
                const WallSums& sums) const;
    /// Where a centre is in the surface's own frame.
    [[nodiscard]] core::Vec3 own(const core::Vec3& x) const { return frame_.moves() ? frame_.now().own(x) : x; }

    /// Takes the contacts of owned particle i from its row of `history`.
    void recall(int i, const core::ContactHistory& history, Chunk& chunk) const;
    void make_filters(const core::ParticleSet& particles, Chunk& chunk) const;
    void choose_near(const core::ParticleSet& particles, Chunk& chunk) const;

    WallSurface surface_; ///< In its own frame.
    WallFrame frame_;
    Place place_;
    std::optional<SurfaceSide> side_; ///< In its own frame.
    double near_skin_ = 0.0;
    std::vector<Chunk> chunks_;
};

} // namespace physics
