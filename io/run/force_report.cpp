// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/force_report.hpp"
#include "io/build/coupling_builder.hpp"
#include "physics/coupling/left_out.hpp"
#include "physics/coupling/own_disturbance.hpp"
#include <fmt/format.h>

namespace io {
namespace {

/// Extremes of the particles of a scene, with what bounds the forces on them.
struct Extremes {
    double diffusion = 0;   ///< nu / d^2 of the largest: where inertia is first felt [1/s]
    double lightest = 0;    ///< density over that of the fluid
    double spin_time = 0;   ///< of the largest [s]
    double disturbance = 0; ///< of the largest, in creeping flow, of its slip
};

Extremes extremes_of(const GrainCensus& census, const physics::CouplingParameters& p)
{
    const double d = census.largest, diffusion = p.viscosity / p.fluid_density / (d * d);
    Extremes e{diffusion, census.least_density / p.fluid_density, 0, 0};
    e.spin_time = physics::spin_time(census.least_density, diffusion, p.fluid_density);
    const double stokes = 3 * std::numbers::pi * p.viscosity * d;
    const physics::Wake wake = physics::wake_of({stokes, 0, p.filter_width * p.filter_width, 0, p.fluid_density, p.viscosity});
    if (p.filter_width > 0) e.disturbance = wake.share;
    return e;
}

std::string line(const std::string& term, bool acts, const std::string& how, const std::string& bound)
{
    return fmt::format("  {:<16} {}\n", term, acts ? how : "left out: " + bound);
}

} // namespace

std::string force_report(const Scene& scene)
{
    const GrainCensus census = census_of(scene);
    const physics::CouplingParameters p = coupling_parameters(scene, census);
    const Extremes e = extremes_of(census, p);
    const Coupling coupling = scene.coupling.value_or(Coupling{});
    const auto word = [](auto chosen, const auto& words) { return std::string(words[std::size_t(chosen)]); };
    const std::string percent = fmt::format("{:g} % of Stokes drag", 100 * physics::left_out_share);
    const bool gradient = p.force == physics::FluidForce::pressure_gradient;
    std::string text = "forces of the fluid on the particles:\n";
    text += line("drag", true, word(coupling.chosen_drag(), drag_law_words) + (p.mixture ? ", by the mean diameter around" : ""), "");
    text += line("pressure, stress", gradient, "V (-grad p + div tau)", "the seed's rho V Du/Dt stands for it");
    text += line("added mass", p.added_mass > 0,
                 p.added_mass_law == physics::AddedMassLaw::zuber ? "by the fraction around (Zuber)" : "half of the displaced fluid",
                 fmt::format("at most {:.2g} of the fluid's acceleration", physics::added_mass_of_response(e.lightest, 0.5)));
    text += line("Magnus lift", p.lift, word(coupling.chosen_magnus(), magnus_law_words),
                 fmt::format("below {} up to a spin of {:.3g} 1/s against the fluid", percent, physics::spin_of_lift(e.diffusion)));
    text += line("shear lift", p.shear_lift, "Saffman, Mei",
                 fmt::format("below {} up to a shear of {:.3g} 1/s", percent, physics::shear_of_lift(e.diffusion)));
    text += line("torque", p.torque, "viscous", fmt::format("spins would last {:.3g} s", e.spin_time));
    text += line("history", p.history, "Basset",
                 fmt::format("below {} up to an angular frequency of {:.3g} 1/s; at Reynolds numbers above 100 it fades early", percent,
                             physics::frequency_of_history(e.diffusion)));
    text += line("dispersion", p.dispersion, "random velocities of the modelled turbulence",
                 scene.fluid->is_turbulent() ? "turbulence that is modelled does not spread particles" : "no turbulence is modelled");
    text += line("own disturbance", p.own_disturbance, "taken off what each particle samples",
                 fmt::format("a particle alone feels up to {:.2g} of its slip too little in creeping flow, none in a bed", e.disturbance));
    return text;
}

} // namespace io
