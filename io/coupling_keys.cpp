// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/coupling_keys.hpp"
#include "io/schema.hpp"

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

void describe(Schema& s, Coupling& p)
{
    s.value("mode", "What waits for what in a step; auto chooses by the fluid", choice_of(p.mode, coupling_mode_words));
    s.value("filter", p.filter, "", "Width of the filter between particles and fluid", not_negative);
    s.value("preset",
            "standard: drag of Di Felice, force of the pressure gradient and viscous stress, lift of Lun & Liu; "
            "seed: as printed by Ushijima & Nezu (2001), units repaired: Ergun to a fluid fraction of 0.8 and Wen-Yu with exponent -2.7 "
            "above, rho V Du/Dt instead of the pressure gradient, added mass 1/2, lift coefficient 0.4 times the speed of the surface over "
            "that of the slip, no shear lift",
            choice_of(p.preset, coupling_preset_words));
    s.value("drag", "smooth: Di Felice; seed: the switch from Ergun to Wen-Yu at 0.8; without it, the preset's",
            choice_of(p.drag, drag_law_words));
    s.value("added_mass", "Added mass; auto: unless the particles are much denser than the fluid", choice_of(p.added_mass, switch_words));
    s.value("lift", "Lift of spinning particles; auto: unless they are much denser than the fluid", choice_of(p.lift, switch_words));
    s.value("magnus",
            "Lift law. lun_liu: falls with the Reynolds number, to a fifth at 1000; rubinow_keller: theory for Reynolds numbers below 1; "
            "seed: a fifth of that throughout; without it, the preset's",
            choice_of(p.magnus, magnus_law_words));
    s.value("torque", "Torque of the fluid on spinning particles; auto: by its estimated size", choice_of(p.torque, switch_words));
}

} // namespace io
