// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The k-epsilon model of turbulence: formulas of one place.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace physics {

/// Turbulence of a fluid: k [m2/s2] and its dissipation epsilon [m2/s3].
struct Turbulence {
    double k = 0, epsilon = 0;
};

/// @source  Launder & Spalding, Comput. Methods Appl. Mech. Eng. 3 (1974) 269, table 2.1; wall constants of a smooth wall.
struct KEpsilonConstants {
    double c_mu = 0.09, c_1 = 1.44, c_2 = 1.92, sigma_k = 1.0, sigma_epsilon = 1.3;
    double kappa = 0.4187, wall = 9.793;
    double rough_wall = 8.5; ///< u+ = ln(y / k_s) / kappa + this beyond k_s+ = 70; Nikuradse, VDI-Forschungsheft 361 (1933)
};
inline constexpr KEpsilonConstants k_epsilon{};

/// How walls are seen: through functions that stand for their layers, or as they are, by a grid that resolves the layers.
enum class WallTreatment { functions, resolved };

/// What a scene says about turbulence.
struct TurbulenceParameters {
    Turbulence initial;
    std::map<std::string, Turbulence> entering; ///< by boundary; elsewhere what enters is that of the cells inside
    double roughness = 0;                       ///< of walls, as height of sand grains; of no effect on walls that are resolved [m]
    WallTreatment walls = WallTreatment::functions;
};

/// Turbulence of a given intensity in a flow of a given speed, its eddies of a given size.
/// @param length  Mixing length, about 0.07 of the width of a duct [m].
[[nodiscard]] inline Turbulence turbulence_of(double speed, double intensity, double length)
{
    const double k = 1.5 * intensity * intensity * speed * speed;
    return {k, std::pow(k_epsilon.c_mu, 0.75) * std::pow(k, 1.5) / length};
}

/// Least values: where there is no turbulence, products and ratios of these stay in the range of numbers, and add nothing to the
/// viscosity of any fluid.
inline constexpr Turbulence least_turbulence{1e-20, 1e-28};

/// nu_t = C_mu k^2 / epsilon, at most 1e5 times the viscosity of the fluid, and never so much that one of the normal stresses
/// 2 k / 3 - 2 nu_t S would be negative, in whatever direction [m2/s]. Zero where k is the least: a flow without turbulence makes none.
/// @param strain  2 S_ij S_ij [1/s2].
/// @source  The bound by strain: Durbin, Int. J. Heat Fluid Flow 17 (1996) 89, for three dimensions.
[[nodiscard]] inline double eddy_viscosity(double c_mu, const Turbulence& at, double viscosity, double strain)
{
    constexpr double most = 1e5;
    if (at.k <= least_turbulence.k) return 0.0;
    return std::min({c_mu * at.k * at.k / at.epsilon, at.k / std::sqrt(3 * strain), most * viscosity});
}

/// Production of k [m2/s3]: nu_t |2 S|^2 / 2, held back where strain is so fast that the model would make turbulence without bounds.
/// @param strain  2 S_ij S_ij [1/s2].
/// @source  The bound: Menter, AIAA J. 32 (1994) 1598.
[[nodiscard]] inline double production(double eddy_viscosity, double strain, double epsilon)
{
    constexpr double most = 10;
    return std::min(eddy_viscosity * strain, most * epsilon);
}

/// Integral over a time of what follows dx/dt = gain - loss x^2 from a start, exactly: it decays, or comes to (gain / loss)^(1/2).
/// @param gain, loss  Not negative.
[[nodiscard]] inline double integral_of_decay(double start, double gain, double loss, double time)
{
    const double turns = std::sqrt(gain * loss) * time;
    if (turns > 1) {
        const double left = std::expm1(-2 * turns);
        return (turns + std::log1p(0.5 * left - start * loss * time * left / (2 * turns))) / loss;
    }
    const double whole = turns > 0 ? std::sinh(turns) / turns : 1.0, half = turns > 0 ? std::sinh(turns / 2) / (turns / 2) : 1.0;
    const double straight = time * (start * whole + 0.5 * gain * time * half * half);
    return loss * straight > 0 ? std::log1p(loss * straight) / loss : straight;
}

/// The layer at a wall, seen from a cell beside it. Speeds follow from k, so that nothing vanishes where the flow reverses.
/// @source  Launder & Spalding (1974), section 4.4; roughness: in the form of NUMERICS A4, its factor from Nikuradse's law.
struct WallLayer {
    double friction_speed; ///< C_mu^(1/4) k^(1/2) [m/s]
    double distance;       ///< y* [-]
    double viscosity;      ///< of friction, over that of the fluid: at least 1
    double turbulent;      ///< how far the cell lies outside of the viscous layer, from 0 to 1
};
/// @param y  Distance of the cell's centre from the wall [m].
[[nodiscard]] inline WallLayer wall_layer(double k, double y, double viscosity, double roughness)
{
    const double speed = std::pow(k_epsilon.c_mu, 0.25) * std::sqrt(k), distance = speed * y / viscosity;
    const double grains = k_epsilon.wall * std::exp(-k_epsilon.kappa * k_epsilon.rough_wall); // 0.28
    const double smoothness = k_epsilon.wall / (1 + grains * speed * roughness / viscosity);
    // Below y* = 11.2 the viscous law u+ = y* is the lower one, and holds; on rough walls u+ does not fall below 1.
    const double speed_ratio = std::max(1.0, std::log(std::max(smoothness * distance, 1.0)) / k_epsilon.kappa);
    // Kader, Int. J. Heat Mass Transfer 24 (1981) 1541, eq. (33).
    const double blend = 0.01 * std::pow(distance, 4) / (1 + 5 * distance);
    return {speed, distance, std::max(1.0, distance / speed_ratio), blend > 0 ? std::exp(-1 / blend) : 0.0};
}

/// Dissipation in a cell beside a wall: of the logarithmic layer, and 2 nu k / y^2 of the viscous layer [m2/s3].
[[nodiscard]] inline double wall_dissipation(const WallLayer& layer, double k, double y, double viscosity)
{
    const double logarithmic = std::pow(layer.friction_speed, 3) / (k_epsilon.kappa * y);
    return layer.turbulent * logarithmic + (1 - layer.turbulent) * 2 * viscosity * k / (y * y);
}

/// Production in a cell beside a wall: friction times the slope of the logarithmic law [m2/s3].
/// @param slip  Speed along the wall, relative to it [m/s].
[[nodiscard]] inline double wall_production(const WallLayer& layer, double slip, double y, double viscosity)
{
    return layer.turbulent * layer.viscosity * viscosity * slip / y * layer.friction_speed / (k_epsilon.kappa * y);
}

} // namespace physics
