// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/coupling_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {

DragLaw Coupling::chosen_drag() const
{
    if (drag) return *drag;
    return preset == CouplingPreset::seed ? DragLaw::seed : DragLaw::smooth;
}

MagnusLaw Coupling::chosen_magnus() const
{
    if (magnus) return *magnus;
    return preset == CouplingPreset::seed ? MagnusLaw::seed : MagnusLaw::lun_liu;
}

void describe(Schema& s, Lubrication& p)
{
    s.value("roughness", p.roughness, "", "Gap below which the film resists no more: the height of what is rough", positive);
    s.value("range", p.range, "", "Gap from which on there is a film", positive);
}

void describe(Schema& s, Coupling& p)
{
    s.value(
        "feedback",
        "two_way: fluid and particles feel each other; one_way: particles feel the fluid, which flows as if there were none, their drag "
        "that of particles alone; for few of them",
        choice_of(p.feedback, feedback_words));
    s.value("mode", "What waits for what in a step; auto chooses by the fluid", choice_of(p.mode, coupling_mode_words));
    s.value("filter", p.filter, "", "Width of the filter between particles and fluid", not_negative);
    s.value("preset",
            "standard: drag of Di Felice, force of the pressure gradient and viscous stress, lift of Lun & Liu; "
            "seed: as printed by Ushijima & Nezu (2001), units repaired: Ergun to a fluid fraction of 0.8 and Wen-Yu with exponent -2.7 "
            "above, rho V Du/Dt instead of the pressure gradient, added mass 1/2, lift coefficient 0.4 times the speed of the surface over "
            "that of the slip, no shear lift",
            choice_of(p.preset, coupling_preset_words));
    s.value(
        "drag",
        "Drag law. smooth: Di Felice, at any fluid fraction; seed: the switch from Ergun to Wen-Yu at 0.8; gidaspow: the same, blended; "
        "beetstra, rong, tenneti: fits to resolved flow through arrays of spheres, to Reynolds numbers of 1000, 3000 and 300; "
        "schiller_naumann: one sphere alone; wen_yu: suspensions; ergun: packed beds; without it, the preset's",
        choice_of(p.drag, drag_law_words));
    s.value("size_mixture",
            "Drag of each particle by the mean diameter around it and its own (van der Hoef and others, 2005); auto: with beetstra, rong "
            "and tenneti where diameters differ",
            choice_of(p.size_mixture, switch_words));
    s.value("added_mass",
            "Added mass. on: half of the displaced fluid; zuber: more where other particles are around; auto: on unless the particles are "
            "much denser than the fluid",
            choice_of(p.added_mass, added_mass_words));
    s.value("lift", "Lift of spinning particles; auto: unless they are much denser than the fluid", choice_of(p.lift, switch_words));
    s.value("magnus",
            "Lift law. lun_liu: falls with the Reynolds number, to a fifth at 1000; rubinow_keller: theory for Reynolds numbers below 1; "
            "seed: a fifth of that throughout; without it, the preset's",
            choice_of(p.magnus, magnus_law_words));
    s.value("shear_lift", "Lift of particles in shear (Saffman, Mei); auto: off, 'isago plan' estimates it",
            choice_of(p.shear_lift, switch_words));
    s.value("torque", "Torque of the fluid on spinning particles; auto: by its estimated size", choice_of(p.torque, switch_words));
    s.value("history",
            "History force (Basset), whose memory fades where the slip carries vorticity away (Mei and Adrian); auto: off, 'isago plan' "
            "estimates it",
            choice_of(p.history, switch_words));
    s.value("dispersion",
            "Spreading by turbulence that is modelled, as random velocities that particles meet; auto: where the fluid has such a model",
            choice_of(p.dispersion, switch_words));
    s.value(
        "own_disturbance",
        "Takes off what a particle itself adds to the filtered fluid it samples; auto: where particles fill less than 0.1 % of the domain",
        choice_of(p.own_disturbance, switch_words));
    s.group(
        "lubrication", p.lubrication,
        "Films of fluid between particles, and at walls, that resist approach and parting, 6 pi mu R^2 v / gap; sub-steps follow from the "
        "roughness and the viscosity");
}

} // namespace io
