// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The spheres of one rank as a structure of arrays: those it owns first, then its copies of others' (ghosts).
#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

using Column = std::vector<double>;
/// One column for each component of a vector.
using Triple = std::array<Column, 3>;

/// One sphere as the user gives it; position relative to the domain's origin.
struct Sphere {
    Vec3 position = Vec3::Zero(); ///< [m]
    double radius = 0.0;          ///< [m]
    double density = 0.0;         ///< [kg/m3]
    Vec3 velocity = Vec3::Zero(); ///< [m/s]
    Vec3 spin = Vec3::Zero();     ///< [1/s]
    std::int64_t id = 0;          ///< Unique and not negative.
    std::int32_t species = 0;
};

struct ParticleSet {
    Triple position; ///< Relative to the domain's origin [m].
    Triple velocity; ///< [m/s]
    Triple spin;     ///< Angular velocity [1/s].
    Column radius;   ///< [m]
    Column mass;     ///< [kg]
    Column inertia;  ///< [kg m2]
    std::vector<std::int64_t> id;
    std::vector<std::int32_t> species;
    std::vector<Column> columns; ///< What physics keeps for each owned particle; travels with it.
    int owned = 0;

    [[nodiscard]] int size() const { return int(id.size()); }
    [[nodiscard]] int ghosts() const { return size() - owned; }
    [[nodiscard]] Vec3 position_of(int i) const { return at(position, i); }
    [[nodiscard]] Vec3 velocity_of(int i) const { return at(velocity, i); }
    [[nodiscard]] Vec3 spin_of(int i) const { return at(spin, i); }

    /// Adds a column of zeros and returns its number.
    int add_column();
    /// Adds an owned particle. @pre no ghosts
    void add(const Sphere& sphere);
    /// Makes room for `n` ghosts behind the owned particles; their values are not set.
    void resize_ghosts(int n);
    /// Owned particle k becomes what owned particle order[k] was; those not named are dropped, and all ghosts.
    void reorder(std::span<const int> order);
    /// Makes room for `n` owned particles and no ghosts.
    void resize_owned(int n);

    /// Calls visit(column) for each column of reals, in a fixed order, the columns of physics last.
    template <class Set, class Visit>
    static void for_each_column(Set& set, Visit visit)
    {
        for (auto* triple : {&set.position, &set.velocity, &set.spin})
            for (auto& column : *triple) visit(column);
        for (auto* column : {&set.radius, &set.mass, &set.inertia}) visit(*column);
        for (auto& column : set.columns) visit(column);
    }

private:
    static Vec3 at(const Triple& t, int i) { return {t[0][std::size_t(i)], t[1][std::size_t(i)], t[2][std::size_t(i)]}; }
};

} // namespace core
