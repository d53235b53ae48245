// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/parameters.hpp"
#include "physics/coupling/drag.hpp"

namespace physics {

double drag_coefficient(const CouplingParameters& p, double slip, double fraction, double diameter)
{
    const DragInput in{slip, fraction, diameter, p.fluid_density, p.viscosity};
    switch (p.drag) {
    case DragLaw::di_felice: return drag_di_felice(in);
    case DragLaw::gidaspow: return drag_gidaspow(in);
    case DragLaw::kawaguchi: return drag_kawaguchi(in);
    case DragLaw::gidaspow_smooth: return drag_gidaspow_smooth(in);
    case DragLaw::schiller_naumann: return drag_schiller_naumann(in);
    }
    return 0.0;
}

} // namespace physics
