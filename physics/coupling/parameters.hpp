// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene chooses for the exchange between grains and fluid.
#include "core/base/vec3.hpp"
#include "physics/coupling/drag_law.hpp"
#include "physics/coupling/mode.hpp"

#include <cstdint>
#include <optional>

namespace physics {

/// What pushes a grain beside drag, added mass, lift and viscous stress, without drive and weight.
enum class FluidForce {
    pressure_gradient,  ///< V (-grad p): carries the grains' share of a bed's drag (set II)
    material_derivative ///< rho V Du/Dt, as the seed prints it: the same in the fluid alone, nothing in a steady bed
};

/// Coefficient of the added mass.
enum class AddedMassLaw {
    one_sphere, ///< CouplingParameters::added_mass
    zuber       ///< that times what other grains around make of it
};

/// Lift of a grain that spins relative to the fluid (lift.hpp).
enum class MagnusLaw {
    lun_liu,        ///< falls with the Reynolds number of the slip: the default
    rubinow_keller, ///< theory for small Reynolds numbers
    tsuji           ///< measured at Re = 550 to 1600: what the seed takes
};

struct CouplingParameters {
    double fluid_density = 1000.0;           ///< [kg/m3]
    double viscosity = 1e-3;                 ///< dynamic [Pa s]
    core::Vec3 gravity = core::Vec3::Zero(); ///< [m/s2]
    DragLaw drag = DragLaw::di_felice;
    bool mixture = false; ///< corrects drag for unlike sizes (drag_mixture.hpp)
    FluidForce force = FluidForce::pressure_gradient;
    double added_mass = 0.5; ///< coefficient C_m of one sphere; 0 leaves it out
    AddedMassLaw added_mass_law = AddedMassLaw::one_sphere;
    bool lift = false; ///< Magnus, by the spin relative to the fluid
    MagnusLaw magnus = MagnusLaw::lun_liu;
    bool shear_lift = false;       ///< Saffman and Mei
    bool torque = true;            ///< viscous
    bool history = false;          ///< Basset
    bool dispersion = false;       ///< by turbulence that is modelled (dispersion.hpp)
    std::uint64_t random_seed = 1; ///< of what is drawn for it
    bool own_disturbance = false;  ///< takes off what a grain itself adds to the fluid it samples (own_disturbance.hpp)
    double filter_width = 0.0;     ///< bandwidth b of the diffusion filter [m]
    std::optional<Mode> mode;      ///< none: chosen from the stability numbers
};

/// Drag coefficient K of one grain by the chosen law, among grains of its size [kg/s].
[[nodiscard]] double drag_coefficient(const CouplingParameters& parameters, double slip, double fraction, double diameter);

/// Magnus lift by the chosen law over that for small Reynolds numbers [-].
[[nodiscard]] double magnus_share(const CouplingParameters& parameters, double slip, double diameter);

/// Coefficient of the added mass where the fluid fraction is `fraction` [-].
[[nodiscard]] double added_mass_coefficient(const CouplingParameters& parameters, double fraction);

/// Drag at the slip at which drag carries `weight` [N]: what to expect of a grain before anything has moved.
[[nodiscard]] double settling_drag(const CouplingParameters& parameters, double weight, double fraction, double diameter);

} // namespace physics
