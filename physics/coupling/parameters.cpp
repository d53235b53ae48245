// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/parameters.hpp"
#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/drag_laws.hpp"
#include "physics/coupling/lift.hpp"
#include <cmath>

namespace physics {

double drag_coefficient(const CouplingParameters& p, double slip, double fraction, double diameter)
{
    return with_drag_law(p.drag, [&](const auto& law) { return law({slip, fraction, diameter, p.fluid_density, p.viscosity}); });
}

double added_mass_coefficient(const CouplingParameters& p, double fraction)
{
    if (p.added_mass_law == AddedMassLaw::one_sphere) return p.added_mass;
    return p.added_mass / added_mass_of_a_sphere * added_mass_zuber(1.0 - fraction);
}

double magnus_share(const CouplingParameters& p, double slip, double diameter)
{
    switch (p.magnus) {
    case MagnusLaw::lun_liu: return magnus_share_lun_liu(p.fluid_density * slip * diameter / p.viscosity);
    case MagnusLaw::rubinow_keller: return 1.0;
    case MagnusLaw::tsuji: return magnus_share_tsuji;
    }
    return 0.0;
}

double settling_drag(const CouplingParameters& p, double weight, double fraction, double diameter)
{
    double drag = drag_coefficient(p, 0.0, fraction, diameter);
    // Drag grows with the slip by a power between 0 and 1: the mean of the logarithms converges, by a half in each round at least.
    constexpr int rounds = 16;
    for (int n = 0; n < rounds; ++n) drag = std::sqrt(drag * drag_coefficient(p, weight / drag, fraction, diameter));
    return drag;
}

} // namespace physics
