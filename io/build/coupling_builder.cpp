// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/coupling_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "physics/coupling/added_mass.hpp"

#include <numbers>

namespace io {
namespace {

physics::MagnusLaw magnus_law(MagnusLaw chosen)
{
    switch (chosen) {
    case MagnusLaw::lun_liu: return physics::MagnusLaw::lun_liu;
    case MagnusLaw::rubinow_keller: return physics::MagnusLaw::rubinow_keller;
    case MagnusLaw::seed: return physics::MagnusLaw::tsuji;
    }
    return physics::MagnusLaw::lun_liu;
}

bool wanted(Switch choice, bool otherwise) { return choice == Switch::automatic ? otherwise : choice == Switch::on; }

physics::DragLaw drag_law(DragLaw chosen)
{
    using physics::DragLaw;
    // In the order of drag_law_words.
    constexpr std::array laws{DragLaw::di_felice, DragLaw::kawaguchi,        DragLaw::gidaspow_smooth, DragLaw::beetstra, DragLaw::rong,
                              DragLaw::tenneti,   DragLaw::schiller_naumann, DragLaw::wen_yu,          DragLaw::ergun};
    static_assert(laws.size() == drag_law_words.size());
    return laws[std::size_t(chosen)];
}

/// Do particles fill so little of the domain that each meets hardly any wake but its own?
bool stands_alone(const Scene& scene, const GrainCensus& census)
{
    constexpr double few = 1e-3;
    return census.volume < few * (scene.grid.high() - scene.grid.low()).prod();
}

/// [m]
double length_of(const Width& width, const GrainCensus& census)
{
    return width.in_diameters ? width.value * census.mean_diameter() : width.value;
}

bool fits_resolved_flow(physics::DragLaw law)
{
    return law == physics::DragLaw::beetstra || law == physics::DragLaw::rong || law == physics::DragLaw::tenneti;
}

} // namespace

physics::CouplingParameters coupling_parameters(const Scene& scene, const GrainCensus& census)
{
    const Coupling coupling = scene.coupling.value_or(Coupling{});
    const bool seed = coupling.preset == CouplingPreset::seed;
    const double lightest_ratio = census.least_density / scene.fluid->material.density;
    constexpr double heavy = 150; // above it added mass is below 1 % (NUMERICS E)
    physics::CouplingParameters p;
    p.fluid_density = scene.fluid->material.density;
    p.viscosity = scene.fluid->material.viscosity * p.fluid_density;
    p.gravity = gravity_of(scene);
    if (seed) p.force = physics::FluidForce::material_derivative;
    p.magnus = magnus_law(coupling.chosen_magnus());
    p.drag = drag_law(coupling.chosen_drag());
    const bool one_way = is_one_way(scene); // nobody is around a particle that the fluid does not feel
    p.mixture = !one_way && wanted(coupling.size_mixture, fits_resolved_flow(p.drag) && census.smallest < census.largest);
    const bool light = seed || lightest_ratio < heavy;
    p.added_mass = coupling.added_mass == AddedMass::off || (coupling.added_mass == AddedMass::automatic && !light)
                       ? 0.0
                       : physics::added_mass_of_a_sphere;
    if (coupling.added_mass == AddedMass::zuber) p.added_mass_law = physics::AddedMassLaw::zuber;
    p.lift = wanted(coupling.lift, light);
    p.shear_lift = wanted(coupling.shear_lift, false);
    p.history = wanted(coupling.history, false);
    p.dispersion = wanted(coupling.dispersion, scene.fluid->is_turbulent());
    p.random_seed = std::uint64_t(scene.run.random_seed);
    p.own_disturbance = !one_way && wanted(coupling.own_disturbance, stands_alone(scene, census));
    p.torque = wanted(coupling.torque, true);
    p.filter_width = length_of(coupling.filter, census);
    return p;
}

physics::LubricationFilm lubrication_film(const Scene& scene, const GrainCensus& census)
{
    if (!scene.coupling || !scene.coupling->lubrication || !scene.fluid) return {};
    const double viscosity = scene.fluid->material.viscosity * scene.fluid->material.density;
    const Lubrication& keys = *scene.coupling->lubrication;
    return {6 * std::numbers::pi * viscosity, length_of(keys.roughness, census), length_of(keys.range, census)};
}

bool is_one_way(const Scene& scene) { return scene.coupling && scene.coupling->feedback == Feedback::one_way; }

std::optional<physics::Mode> asked_mode(const Scene& scene)
{
    const CouplingMode mode = scene.coupling.value_or(Coupling{}).mode;
    switch (mode) {
    case CouplingMode::automatic: break;
    case CouplingMode::pipelined: return physics::Mode::pipelined;
    case CouplingMode::coarse: return physics::Mode::coarse;
    case CouplingMode::concurrent: return physics::Mode::concurrent;
    case CouplingMode::iterated: return physics::Mode::iterated;
    }
    return std::nullopt;
}

} // namespace io
