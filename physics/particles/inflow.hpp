// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Particles that come in while others move: how many are due, and free places for them. Every rank finds the same.
#include "core/particles/particle_set.hpp"
#include "physics/particles/obstacles.hpp"
#include "physics/particles/region.hpp"
#include "physics/particles/size_distribution.hpp"

#include <cstdint>
#include <limits>

namespace physics {

/// A steady stream of particles of one species.
struct Inflow {
    enum class Measure { number, mass };

    core::Sphere like; ///< Density, velocity and species.
    SizeDistribution sizes;
    Region region; ///< Where centres come in.
    Measure measure = Measure::number;
    double rate = 0.0;                                                 ///< [1/s] or [kg/s]
    double begin = 0.0, end = std::numeric_limits<double>::infinity(); ///< [s]
};

/// What has come in so far: part of the state.
struct Entered {
    std::int64_t count = 0;
    double amount = 0.0; ///< In the measure of the stream: number or mass [kg].
};

/// The spheres that come in by `time`: as many as are due, up to the first that finds no free place, which goes on trying. The place and
/// the size of each follow from the seed and its id.
/// @param near      All that may touch them, in any order; those that come in are added.
/// @param[in,out] next_id  The id of the next sphere.
[[nodiscard]] std::vector<core::Sphere> entering(const Inflow& inflow, double time, const core::Domain& domain, const Obstacles& obstacles,
                                                 std::uint64_t seed, std::vector<core::Sphere>& near, std::int64_t& next_id,
                                                 Entered& entered);

/// May a sphere of this place and radius touch one of the stream, or an image of it?
[[nodiscard]] bool may_meet(const Inflow& inflow, const core::Domain& domain, const core::Vec3& centre, double radius);

} // namespace physics
