// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene chooses for the exchange between grains and fluid.
#include "core/base/vec3.hpp"
#include "physics/coupling/mode.hpp"

#include <optional>

namespace physics {

enum class DragLaw {
    di_felice,       ///< smooth in phi and slip: the default
    gidaspow,        ///< the seed's switch from Ergun to Wen-Yu at phi = 0.8
    gidaspow_smooth, ///< the same, blended
    schiller_naumann ///< one sphere alone
};

struct CouplingParameters {
    double fluid_density = 1000.0;  ///< [kg/m3]
    double viscosity = 1e-3;        ///< dynamic [Pa s]
    core::Vec3 gravity = core::Vec3::Zero(); ///< [m/s2]
    DragLaw drag = DragLaw::di_felice;
    double added_mass = 0.5;        ///< coefficient C_m; 0 leaves it out
    bool lift = false;              ///< Magnus, by the spin relative to the fluid
    bool torque = true;             ///< viscous
    double filter_width = 0.0;      ///< bandwidth b of the diffusion filter [m]
    std::optional<Mode> mode;       ///< none: chosen from the stability numbers
};

/// Drag coefficient K of one grain by the chosen law [kg/s].
[[nodiscard]] double drag_coefficient(const CouplingParameters& parameters, double slip, double fraction, double diameter);

} // namespace physics
