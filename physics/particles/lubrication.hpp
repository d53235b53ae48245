// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The film of fluid between surfaces that approach or part: it resists along the normal before they touch.
//
// F = 6 pi mu R^2 v (1 / max(h, roughness) - 1 / range) at a gap h between 0 and the range, R the reduced radius, v the speed of approach.
// Surfaces that touch have no film: springs carry them. An approach from the range to touching takes 6 pi mu R^2 ln(range / roughness)
// of the momentum of the pair, whatever its speed, and parting as much.
#include "physics/particles/contact_general.hpp"
#include "physics/particles/parameters.hpp"

namespace physics {

/// Integral of 1 / max(h, roughness) - 1 / range from h = 0 to `gap`; constant outside the film [-].
[[gnu::always_inline, nodiscard]] inline double film_integral(const LubricationFilm& film, double gap)
{
    const double h = std::min(std::max(gap, 0.0), film.range);
    return std::min(h, film.roughness) / film.roughness + std::log(std::max(h, film.roughness) / film.roughness) - h / film.range;
}

/// Greatest sub-step for which the films of a particle of this mass take no more than its momentum [s]: 2 contacts F / v step < mass, as
/// stable_step() has it for springs. @param radius  Greatest reduced radius that it meets others with [m].
[[nodiscard]] inline double film_step(const LubricationFilm& film, double mass, double radius, int contacts)
{
    return mass / (contacts * film.factor * radius * radius * (1.0 / film.roughness - 1.0 / film.range));
}

/// Any contact, with the film before it.
/// @source  Brenner (1961), Cox (1974): the leading term for small gaps; Barnocky, Davis (1988): the cut at the roughness.
struct LubricatedContact : GeneralContact {
    LubricationFilm film;

    [[nodiscard]] bool operator==(const LubricatedContact&) const = default;

    /// Force that pushes the two apart, its mean over the way since the last step: impulses do not depend on the step [N].
    [[gnu::always_inline, nodiscard]] inline double film_force(const ContactInput& c) const
    {
        const double gap = -c.overlap, way = step * (c.vx * c.mx + c.vy * c.my + c.vz * c.mz);
        const double within = gap < film.range ? film.factor / step : 0.0;
        return within * c.radius * c.radius * (film_integral(film, gap + way) - film_integral(film, gap));
    }
    [[gnu::always_inline, nodiscard]] inline GeneralOutput operator()(const ContactInput& c) const
    {
        GeneralOutput out = GeneralContact::operator()(c);
        const double push = film_force(c);
        out.fx -= push * c.nx;
        out.fy -= push * c.ny;
        out.fz -= push * c.nz;
        return out;
    }
};

} // namespace physics
