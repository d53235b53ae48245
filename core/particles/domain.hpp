// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The box that holds all particles, and the translations that map it onto its periodic images.
#include "core/base/vec3.hpp"

#include <array>
#include <cmath>

namespace core {

/// Positions of particles are stored relative to `origin`, so that a domain far from zero loses no digits.
struct Domain {
    Vec3 origin = Vec3::Zero(); ///< Corner of the box in the user's coordinates [m].
    Vec3 size = Vec3::Ones();   ///< Lengths of the box [m]; particles may leave it where it is not periodic.
    std::array<bool, 3> periodic{false, false, false};

    /// The lattice vector from one image to the next along `axis` [m]; zero where the box is not periodic.
    [[nodiscard]] Vec3 translation(int axis) const
    {
        return periodic[std::size_t(axis)] ? Vec3(size[axis] * Vec3::Unit(axis)) : Vec3(Vec3::Zero());
    }
    [[nodiscard]] bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
    /// Coordinate x along `axis`, brought back into the box if it is periodic there [m].
    [[nodiscard]] double wrapped(int axis, double x) const
    {
        const double length = size[axis];
        if (!periodic[std::size_t(axis)] || (x >= 0.0 && x < length)) return x;
        const double inside = x - length * std::floor(x / length);
        return inside < length ? inside : 0.0; // a tiny negative x rounds up to the length itself
    }
};

/// Number 0..26 of the image shift (i, j, k), each in -1..1.
[[nodiscard]] constexpr int image_number(int i, int j, int k) { return (i + 1) + 3 * (j + 1) + 9 * (k + 1); }
inline constexpr int no_shift = image_number(0, 0, 0);

/// The 27 shifts between a particle and the images of its neighbours [m].
[[nodiscard]] inline std::array<Vec3, 27> image_shifts(const Domain& domain)
{
    std::array<Vec3, 27> shifts;
    for (int n = 0; n < 27; ++n)
        shifts[std::size_t(n)] =
            (n % 3 - 1) * domain.translation(0) + (n / 3 % 3 - 1) * domain.translation(1) + (n / 9 - 1) * domain.translation(2);
    return shifts;
}

} // namespace core
