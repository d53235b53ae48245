// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Drag laws: coefficient K of one grain, force = K (u - v), finite where the slip is zero.
#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {

/// What a drag law needs to know about a grain and the fluid around it.
struct DragInput {
    double slip = 0.0;      ///< |u - v|, interstitial [m/s]
    double phi = 1.0;       ///< fluid fraction; closures clip it to at least 0.2 [-]
    double diameter = 0.0;  ///< [m]
    double density = 0.0;   ///< of the fluid [kg/m3]
    double viscosity = 0.0; ///< dynamic [Pa s]
};

/// Smallest fluid fraction a closure sees (continuity is never clipped).
inline constexpr double smallest_closure_fraction = 0.2;

/// Drag coefficient times Reynolds number over 24, finite at 0: 1 + 0.15 Re^0.687, constant coefficient above 1000.
/// @source  Schiller, Naumann (1933); jump of 0.4 % at 1000.
[[nodiscard]] inline double drag_over_stokes(double reynolds, double turbulent = 0.44)
{
    return reynolds < 1000.0 ? 1.0 + 0.15 * std::pow(reynolds, 0.687) : turbulent / 24.0 * reynolds;
}

/// One sphere in unbounded fluid: 3 pi mu d (1 + 0.15 Re^0.687) [kg/s].
[[nodiscard]] inline double drag_schiller_naumann(const DragInput& in)
{
    const double reynolds = in.density * in.slip * in.diameter / in.viscosity;
    return 3.0 * std::numbers::pi * in.viscosity * in.diameter * drag_over_stokes(reynolds);
}

/// Packed bed, K = beta V / (1 - phi), beta = 150 (1-phi)^2 mu / (phi d^2) + 1.75 (1-phi) rho |u-v| / d [kg/s].
/// @source  Ergun (1952) in the form of Gidaspow (1994).
[[nodiscard]] inline double drag_ergun(const DragInput& in)
{
    const double phi = std::max(in.phi, smallest_closure_fraction);
    const double d = in.diameter;
    const double volume = std::numbers::pi / 6.0 * d * d * d;
    return volume * (150.0 * (1.0 - phi) * in.viscosity / (phi * d * d) + 1.75 * in.density * in.slip / d);
}

/// Numbers in the law of Wen and Yu that its users print differently.
struct SuspensionNumbers {
    double exponent = -2.65; ///< of phi
    double turbulent = 0.44; ///< drag coefficient above Re = 1000
};

/// Suspension: Schiller-Naumann at Re = rho phi |u-v| d / mu times phi^-2.65 [kg/s].
/// @source  Wen, Yu (1966).
[[nodiscard]] inline double drag_wen_yu(const DragInput& in, const SuspensionNumbers& numbers = {})
{
    const double phi = std::max(in.phi, smallest_closure_fraction);
    const double reynolds = in.density * phi * in.slip * in.diameter / in.viscosity;
    return 3.0 * std::numbers::pi * in.viscosity * in.diameter * drag_over_stokes(reynolds, numbers.turbulent) *
           std::pow(phi, numbers.exponent);
}

/// The seed's law: Ergun up to phi = 0.8, Wen-Yu above. It jumps there (3.7 times at Re = 1000): lineage runs only.
/// @source  Tsuji, Kawaguchi, Tanaka (1993) with phi^-2.7 and 0.43; the units of Ushijima & Nezu (2001), equation 8, repaired.
[[nodiscard]] inline double drag_kawaguchi(const DragInput& in) { return in.phi > 0.8 ? drag_wen_yu(in, {-2.7, 0.43}) : drag_ergun(in); }

/// Ergun up to phi = 0.8, Wen-Yu above, with their own numbers.
/// @source  Gidaspow (1994).
[[nodiscard]] inline double drag_gidaspow(const DragInput& in) { return in.phi > 0.8 ? drag_wen_yu(in) : drag_ergun(in); }

/// Ergun and Wen-Yu blended over some 0.01 of phi around 0.8.
/// @source  Huilin, Gidaspow (2003), switch function atan.
[[nodiscard]] inline double drag_gidaspow_smooth(const DragInput& in)
{
    const double suspension = 0.5 + std::atan(150.0 * (in.phi - 0.8)) / std::numbers::pi;
    return suspension * drag_wen_yu(in) + (1.0 - suspension) * drag_ergun(in);
}

/// Drag of one sphere, C_D pi/8 d^2 rho U^2 over |u-v| and phi, U = phi |u-v|, C_D = (0.63 + 4.8 / sqrt Re)^2 [kg/s].
/// C_D Re is written (0.63 sqrt Re + 4.8)^2, finite at zero slip.
/// @source  Dalla Valle (1948).
[[nodiscard]] inline double drag_dalla_valle(double reynolds, const DragInput& in)
{
    const double root = 0.63 * std::sqrt(reynolds) + 4.8;
    return std::numbers::pi / 8.0 * in.viscosity * in.diameter * root * root;
}

/// Default: smooth in phi and slip from one grain to the packed bed, fit for beds that move [kg/s].
/// Force = C_D pi/8 d^2 rho U^2 phi^-chi with U = phi |u-v|, beside the pressure-gradient force V(-grad p) (set II);
/// Re = rho U d / mu, chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2).
/// @source  Di Felice (1994); Dalla Valle (1948) for C_D.
[[nodiscard]] inline double drag_di_felice(const DragInput& in)
{
    const double phi = std::max(in.phi, smallest_closure_fraction);
    const double reynolds = in.density * phi * in.slip * in.diameter / in.viscosity;
    const double decades = 1.5 - std::log10(std::max(reynolds, 1e-12));
    const double chi = 3.7 - 0.65 * std::exp(-0.5 * decades * decades);
    return drag_dalla_valle(reynolds, in) * std::pow(phi, 1.0 - chi);
}

} // namespace physics
