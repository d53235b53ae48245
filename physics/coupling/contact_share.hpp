// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much of the load on a grain its contacts carry, and how far it may yield in predictor and projection.
#include "physics/coupling/response.hpp"
#include <algorithm>

namespace physics {

/// Share of the applied impulse that contacts took up over a step: 1 for a grain at rest in a bed, 0 for a free one.
/// @param contact_dot_applied  I_c . I_a, contact impulse times applied impulse (all but contacts) [N2 s2].
/// @param applied_squared      I_a . I_a [N2 s2]; 0 gives 0.
[[nodiscard]] inline double contact_share(double contact_dot_applied, double applied_squared)
{
    return applied_squared > 0.0 ? std::clamp(-contact_dot_applied / applied_squared, 0.0, 1.0) : 0.0;
}

/// The same of what changed between two passes over one step: how far a grain gives way to a change, whatever it carries. Springs
/// may carry all of a load and yet let a grain go with the fluid through the whole step, when they are soft against its drag; a
/// grain that slides carries its part and takes no more.
/// @param share             contact_share() of the second pass.
/// @param dot, squared      As there, of the changes.
/// @param applied_squared   Of the second pass: changes below round-off of the impulses say nothing, `share` remains.
[[nodiscard]] inline double changed_share(double share, double dot, double squared, double applied_squared)
{
    constexpr double round_off = 1e-20; // of squares
    return squared > round_off * applied_squared ? contact_share(dot, squared) : share;
}

/// Yield in the predictor: a held grain takes the full drag. Too stiff only lags, too soft is unstable for stiff drag.
[[nodiscard]] inline double predictor_yield(double hold) { return 1.0 - hold; }

/// Part of the drag reaction that meets the fluid as it is in each cell, not as the filter shows it to the grains [kg]. What the
/// filter hides would else flow through a bed of held grains without resistance, and grow. A free grain would go with it.
/// @param predictor  Response of a grain in the predictor.
[[nodiscard]] inline double held_drag(const GrainResponse& predictor, double hold) { return hold * (predictor.reaction - predictor.added); }

/// Yield in the projection: too soft only lags, too stiff is unstable; only stiff drag earns the hold. With 1 / (1 + b)^2 a
/// held grain stays as soft as a free one where b is small. Where b is large it yields to 0.3 / (1 + b), that is, takes three
/// quarters of the full drag, and a locked bed has half of its pressure drop after one pass: with 0.2 a column of 50 um
/// grains in water chatters in one pass, with 0.1 it blows up.
/// @param stiffness  b = K dt / m [-].
[[nodiscard]] inline double projection_yield(double hold, double stiffness)
{
    const double soft = 1.0 / (1.0 + stiffness);
    return 1.0 - hold * (1.0 - soft * std::max(soft, 0.3));
}

} // namespace physics
