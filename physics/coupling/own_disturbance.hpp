// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a grain itself adds to the filtered fluid around it, to be taken off before it meets its drag law, which is meant for the
// fluid undisturbed by it.
//
// The force of a grain on the fluid is spread by hats and filter, and the velocity it samples is gathered by them again: a Gaussian of
// variance s^2 in each direction. In creeping flow without walls a force F that is spread so makes F / (3 pi sqrt(2 pi) mu s) at its
// centre, 0.40 d / s of the slip of a Stokes grain. Faster flow carries the wake away (Oseen), other grains stop it (Brinkman), and it
// needs the time s^2 / nu to build up.
#include "physics/coupling/grid_spread.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {

/// Variance in each direction of what is spread and gathered again: filter and hats twice, and what cells of width h make of it. A force
/// in one cell without a filter makes a velocity that a Gaussian of 0.0632 h^2 would (the seven-point operator answers 0.2527 / h for
/// 1 / (2 pi)^1.5 / s). With a filter, x = b^2 / (2 h^2), a scalar on cells is spread by less than the Gaussian, by up to 0.3 h^2, fitted
/// by (-0.25 + (0.3132 - 0.9 x) exp(-2.2 x)) h^2; of that half is found in the flow that the projection makes.
[[nodiscard]] inline double velocity_spread(double filter_width, const GridSpread& grid)
{
    constexpr double unfiltered = 0.0632;
    const double x = 0.5 * filter_width * filter_width / grid.cell;
    const double of_scalar = -0.25 + (0.25 + unfiltered - 0.9 * x) * std::exp(-2.2 * x);
    return filter_width * filter_width + 0.5 * (unfiltered + of_scalar) * grid.cell + 2.0 * grid.hat;
}

/// 1 - sqrt(pi) z exp(z^2) erfc(z), from 1 to 1 / (2 z^2): what is left of a velocity at the centre of a Gaussian of variance s^2
/// in a medium of resistance alpha^2 mu, z = alpha s / sqrt 2.
[[nodiscard]] inline double screened_share(double z)
{
    if (z > 6.0) {
        const double inverse = 1.0 / (2.0 * z * z);
        return inverse * (1.0 - 3.0 * inverse * (1.0 - 5.0 * inverse * (1.0 - 7.0 * inverse)));
    }
    return 1.0 - std::sqrt(std::numbers::pi) * z * std::exp(z * z) * std::erfc(z);
}

/// The velocity of Oseen's flow at the centre of a Gaussian force over that of Stokes' flow, along the slip: the mean of
/// (3/2)(1 - x^2) screened_share(R x) over x = 0..1, R = rho U s / (mu sqrt 2). From 1 to 1.33 / R.
[[nodiscard]] inline double oseen_share(double r)
{
    const double root = std::sqrt(std::numbers::pi);
    if (r < 0.02) return 1.0 - r * (0.375 * root - 0.4 * r);     // the closed form cancels there; left out: r^3
    if (r > 1e4) return 0.75 * root / r;                         // and there; left out: 1 / r^2
    const double decay = (1.0 - screened_share(r)) / (root * r); // exp(r^2) erfc(r)
    const double first = 0.5 * (decay - 1.0) + r / root;
    const double third = 0.5 * r * r * decay - first + r * r * r / (3.0 * root);
    return 1.0 - 1.5 * root * (first / r - third / (r * r * r));
}

/// Variance of the number of hard spheres in a large volume over their mean number: how much of its own volume a grain finds added
/// to the mean around it. From 1 for few to nearly 0 in a packing, where grains keep their distance.
/// @source  Carnahan, Starling (1969).
[[nodiscard]] inline double own_share_of_fraction(double solid)
{
    const double free = 1.0 - solid, c = solid;
    return free * free * free * free / (1.0 + c * (4.0 + c * (4.0 + c * (-4.0 + c))));
}

/// Solid fraction that a grain alone finds where it is: hats, the filter once, hats. Diffusion over b^2 / 4 brings exp(-x) I_n(x),
/// x = b^2 / (2 h^2), of a cell's content to its n-th neighbour along each line of cells of width h.
[[nodiscard]] inline double own_fraction(double volume, double filter_width, const GridSpread& grid)
{
    const double x = 0.5 * filter_width * filter_width / grid.cell, apart = grid.hat / grid.cell;
    const double width = std::sqrt(grid.cell);
    double along = 1.0 / std::sqrt(2.0 * std::numbers::pi * (x + 2.0 * apart)); // where cells are thin: the Gaussian; left out: 1 / (8 x)
    if (x < 50.0) along = std::exp(-x) * ((1.0 - 2.0 * apart) * std::cyl_bessel_i(0.0, x) + 2.0 * apart * std::cyl_bessel_i(1.0, x));
    return volume * std::pow(along / width, 3);
}

/// Solid fraction around a grain without its own share. @param solid  Sampled [-].   @param own  own_fraction() [-].
[[nodiscard]] inline double fraction_of_others(double solid, double own)
{
    double others = std::max(0.0, solid - own);
    // The share changes by eight times what others do, times own: three rounds leave some (8 own)^4.
    for (int n = 0; n < 3; ++n) others = std::max(0.0, solid - own * own_share_of_fraction(std::min(others, 1.0)));
    return others;
}

/// Solid fraction that stops wakes. Of what a grain alone finds a quarter more is taken off, for that is known no better on coarse cells,
/// and a little resistance stops much of a wake.
[[nodiscard]] inline double crowding_fraction(double solid, double own) { return std::max(0.0, solid - 1.25 * own); }

/// What a grain and the fluid around it are.
struct WakeInput {
    double drag = 0.0;      ///< K [kg/s]
    double slip = 0.0;      ///< |u - v| without the wake [m/s]
    double spread = 0.0;    ///< velocity_spread() [m2]
    double crowding = 0.0;  ///< other grains per volume [1/m3]
    double density = 0.0;   ///< of the fluid [kg/m3]
    double viscosity = 0.0; ///< dynamic [Pa s]
};

/// Steady wake at a grain: velocity that it adds where it samples, over its slip, and the time in which that builds up.
struct Wake {
    double share = 0.0; ///< [-]
    double time = 0.0;  ///< [s]
};

/// The largest share that is believed: a grain that would sample hardly anything but itself is beyond the model.
inline constexpr double largest_wake_share = 0.8;

/// The time is that in which the force alone would accelerate the fluid to the steady velocity, s^2 / nu in creeping flow.
/// @source  Ireland, Desjardins (2017); Balachandar, Liu, Lakhote (2019), with hats, screening and growth added.
[[nodiscard]] inline Wake wake_of(const WakeInput& in)
{
    if (in.drag == 0.0) return {};
    const double s = std::sqrt(in.spread), root = std::sqrt(2.0 * std::numbers::pi);
    const double carried = oseen_share(in.density * in.slip * s / (std::numbers::sqrt2 * in.viscosity));
    const double screened = screened_share(s * std::sqrt(0.5 * in.crowding * in.drag / in.viscosity));
    const double creeping = in.drag / (3.0 * std::numbers::pi * root * in.viscosity * s);
    const double share = creeping * carried * screened;
    const double growth = in.density * root * root * root * in.spread * s / (2.0 / 3.0 * in.drag); // s per unit of share
    return {std::min(share, largest_wake_share), share * growth};
}

} // namespace physics
