// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lift on a spinning grain (Magnus) and on a grain in shear (Saffman-Mei).
#include "core/base/vec3.hpp"

#include <cmath>
#include <numbers>

namespace physics {

/// A grain and the fluid around it, as lift and torque see them.
struct SpinInput {
    core::Vec3 slip = core::Vec3::Zero();      ///< u - v [m/s]
    core::Vec3 vorticity = core::Vec3::Zero(); ///< curl u [1/s]
    core::Vec3 spin = core::Vec3::Zero();      ///< of the grain [1/s]
    double diameter = 0.0;                     ///< [m]
    double density = 0.0;                      ///< of the fluid [kg/m3]
    double viscosity = 0.0;                    ///< dynamic [Pa s]
};

/// Magnus lift for small Reynolds numbers, (pi/8) rho d^3 (u - v) x (spin - vorticity/2) [N].
/// Sign: a grain that moves along +x and spins about +z in fluid at rest is pushed to +y.
/// @source  Rubinow, Keller (1961).
[[nodiscard]] inline core::Vec3 magnus_lift(const SpinInput& in)
{
    const double d = in.diameter;
    const core::Vec3 relative = in.spin - 0.5 * in.vorticity;
    return std::numbers::pi / 8.0 * in.density * d * d * d * in.slip.cross(relative);
}

/// Measured lift over magnus_lift(), whose lift coefficient is d |spin| / |u - v|, at Re = 550 to 1600: the coefficient is
/// (0.40 +- 0.10) times the speed of the surface over that of the slip, d |spin| / (2 |u - v|).
/// @source  Tsuji, Morikawa, Mizuno (1985).
inline constexpr double magnus_share_tsuji = 0.2;

/// Lift over magnus_lift(): a fit to the theory for Re = rho d |u - v| / mu up to 1 and to measurements up to 1000, some to 2000.
/// @source  Lun, Liu (1997).
[[nodiscard]] inline double magnus_share_lun_liu(double reynolds)
{
    return reynolds > 1.0 ? 0.178 + 0.822 * std::pow(reynolds, -0.522) : 1.0; // 1 too without slip and viscosity, 0 / 0
}

/// Shear lift, 1.615 d^2 sqrt(rho mu / |w|) (u - v) x w f(Re, Re_s), w = curl u; zero without vorticity [N].
/// Sign: in u = +y along x, a grain that lags is pushed to +y.
/// @source  Saffman (1965); f by Mei (1992), for Re up to 100.
[[nodiscard]] inline core::Vec3 shear_lift(const SpinInput& in)
{
    const double w = in.vorticity.norm();
    const double speed = in.slip.norm();
    if (w == 0.0 || speed == 0.0) return core::Vec3::Zero();
    const double d = in.diameter;
    const double reynolds = in.density * speed * d / in.viscosity;
    const double shear = 0.5 * w * d / speed;
    const double root = 0.3314 * std::sqrt(shear);
    const double factor = reynolds <= 40.0 ? (1.0 - root) * std::exp(-0.1 * reynolds) + root : 0.0524 * std::sqrt(shear * reynolds);
    return 1.615 * d * d * std::sqrt(in.density * in.viscosity / w) * factor * in.slip.cross(in.vorticity);
}

} // namespace physics
