// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How grains and fluid answer an impulse together: the algorithm that exchanges momentum, and its coefficients.
//
// THE EXCHANGE OF MOMENTUM, one step from state n to n+1 (NUMERICS B0 with a response that is summed grain by grain).
// B samples a cell field at a grain (interpolation after the filter), its transpose deposits: put(q) = sum over grains of
// B^T q / cell volume. Both use the positions of one time level inside a formula, so sums at grains and cells are equal.
// Per grain: mass m, volume V, drag coefficient K [kg/s] frozen over the step, added mass a = C_m rho V, kappa = K dt + a,
// hold h in 0..1 (contact_share.hpp), owed impulse. Per cell: phi, C = 1 - phi, G = -grad p + div tau - drive [N/m3],
// Dudt = (u^{n+1} - u^a) / dt of the last step, ledger L [N s/m3].
//
// (div tau, that of u^n, acts on the grains alone here: for the fluid it is in u^a. It does not change within a step: what
// grains are not told of the fluid's acceleration is all in Dudt.)
//
//  1. Fluid lane, beside 2:  u^a = u^n advected and diffused, from state n alone; what diffuses is u^n + dt Dudt^n, the fluid as
//     grains hold it back, not as the drive alone would make it.
//  2. Grain lane (all DEM sub-steps): frozen B u^n, force f = V B G^n + (rho_p - rho) V g + owed / dt + a B D^n and
//     contacts; exact exponential drag with mass m + a. D = Dudt + div tau / rho is the fluid's whole acceleration: in a steady
//     parallel flow it is zero, although the pressure falls. Record per grain the contact impulse I_c and
//        J = m (v^{n+1} - v^n) - (f - a B D) dt - I_c        the impulse of drag, added mass and lift it really received
//     (lift acts in the sub-steps beside f; the fluid feels its reaction through J).
//     A grain that was held in the last step is not told all of a B D^n (told_acceleration in added_mass.hpp): e, what is
//     left out times dt, joins the miss of this grain in 4 (put(J) gets put(added e)) and 6.
//  3. Hold h = contact_share(I_c, m (v^{n+1} - v^n) - I_c), per grain; q = predictor_yield(h) in the predictor,
//     q = projection_yield(h, b) in the projection, b = K dt / m. Move B to the positions n+1. Deposit (filtered):
//        C, put(V v), put(J), the held drag r (contact_share.hpp), and of response.hpp  predictor: reaction, flux, added, added_flux;
//        projection: reaction, entrained, displaced.
//     Order in time: the sub-steps see u^n alone, and the reaction to du makes up for it with the share g of du that is the mean over the
//     step (growth_share); to J and to what is owed the same response to B^{n+1} u^n - B^n u^n, the change on the way of the grain, is
//     added. K is that of the middle of the step, by its change over the last one, while relaxation is slow (K dt (1 + M) / m < 1, M the
//     loading). Pressure is solved for at the middle of steps. Drag and added mass of free grains are second order in every mode.
//  4. Predictor (predictor.hpp), miss = u^n - u^a - dt Dudt:
//        du = [L + dt phi G^n - put(J) - hidden + rho phi (u^a - u^n) - added miss] / (rho phi + reaction_p)
//        hidden = put(r) u^n - put(r B u^n): drag of held grains on what the filter hides of u; no momentum in sum
//        u* = u^n + du,   solid flux* = put(V v) + flux du + added_flux miss
//  5. Projection: ru = dt (phi + entrained) / (rho phi + reaction_q),  mobility = (phi + entrained) ru + dt displaced:
//        div(mobility dG) = - div(phi u* + solid flux*),   dG = - grad(dp);   u^{n+1} = u* + ru dG,  G^{n+1} = G^n + dG.
//     (Total volume flux phi u + solid flux is free of divergence at n+1; the factor mobility stands on the faces.)
//  6. True-up per grain (true_up.hpp): what the fluid gave beyond J is owed and delivered evenly over the next interval.
//  7. Ledger per cell: what the fluid is still owed, added in 4 of the next step. None where the grains' real impulse is
//     waited for and advection is semi-Lagrangian: u^a is then a velocity, which no error of continuity may change (a uniform
//     flow stays uniform), and what its momentum rho (phi^{n+1} u^a - phi^n u^n) makes or loses is a line of the budget.
//     In `coarse` and `concurrent`: what is left of the fluid's equation with the real sums in place of those it took,
//        L = L^n + dt phi G^{n+1} + rho phi (u^a - u^{n+1}) - put(J) - hidden - added miss - reaction_p du - (reaction_q ru -
//        entrained dt) dG,
//     whatever the places of those it took. With finite volumes, in any mode: besides, what their flux F of the fluid and the places of the
//     grains disagree by, moved by a flux that makes up for it (coupled_advection.cpp). With any flux form (test column): besides,
//        L = rho phi^n u^n - dt div(F rho u) - rho phi^{n+1} u^a,  F the volume flux of the fluid at n   (conserved_ledger).
// The filtered u, -grad p and Dudt of n+1 are made once: for 6, and kept for 2 of the next step. du, dG and miss at the grains
// are differences of them, for filter and sampling are linear.
// `iterated` repeats 2-6, and of 1 what diffuses, from state n with u, Dudt and G of the last pass in place of those of state n:
// then step 4 has rho phi (u^a - u_used), hidden is that of u_used, and miss = u_used - u^a - dt Dudt_used; what is owed stays
// that of state n, where slip relaxes fast K becomes the mean of the last pass's and that of u_used (Newton's method where drag
// is quadratic); drag sees u^n and the share g of u_used - u^n. The first step of a run:
// `iterated`. `coarse` takes C, v, J, h of 3-5 from a DEM pass of longer sub-steps, `concurrent` from free flight held back by h of
// the last step, at the places n: nothing in the fluid lane waits for the grains.
//
// Soft springs: a held grain that its drag carries along on its springs through the whole step, K / (k dt) > 0.3 with k the stiffness
// of the bed as a whole, moves with the fluid like a mass on a spring. One pass feeds that sway where b M > 0.5 (mode.cpp): then
// `auto` iterates. A hold by the load would be far too stiff for it, and where b M > 2 three passes do not make up for that: from the
// second pass on the hold is then that of what changed since the pass before (changed_share), which a bed that is truly locked has
// too. The price: what the filter hides of the flow is held back less (held_drag), by k dt / (2 K); the user is warned.
//
// Why it is stable: the predictor must not be softer than the truth (it over-corrects drag), the projection not stiffer (it
// over-corrects pressure); hence two holds. Grain by grain, because a cell of held and free grains is neither.
#include <cmath>

namespace physics {

/// What one grain does to its cell when the fluid there is pushed; deposit each member.
struct GrainResponse {
    double reaction = 0.0;   ///< impulse on the grain per change of fluid velocity, while the grain yields [kg]
    double flux = 0.0;       ///< solid volume flux per change of fluid velocity [m3]
    double displaced = 0.0;  ///< solid volume flux per impulse density, V^2 q / (m + q kappa) [m6/kg]
    double added = 0.0;      ///< reaction to untold fluid acceleration through added mass [kg]
    double added_flux = 0.0; ///< solid volume flux by untold fluid acceleration [m3]
};

/// Mass, volume and coupling of one grain over one step.
struct GrainCoupling {
    double mass = 0.0;       ///< m [kg]
    double volume = 0.0;     ///< V [m3]
    double drag = 0.0;       ///< K dt [kg]
    double added_mass = 0.0; ///< a = C_m rho V [kg]
    double growth = 1.0;     ///< share of a change of fluid velocity over the step that drag sees, as a mean over it [-]
};

/// What follows from impulse per compliance: all that a grain contributes to the sums of its cell.
/// @param ease  compliance / yield [1/kg], finite for a held grain.
[[nodiscard]] inline GrainResponse grain_response(const GrainCoupling& grain, double yield, double ease)
{
    const double kappa = grain.drag + grain.added_mass, c = yield * ease, kept = grain.mass * ease;
    return {kappa * kept, grain.volume * c * kappa, c * grain.volume * grain.volume, grain.added_mass * kept,
            grain.volume * c * grain.added_mass};
}

/// Answer to a change of pressure, for the projection: implicit, softer than the truth.
[[nodiscard]] inline GrainResponse response_to_pressure(const GrainCoupling& grain, double yield)
{
    return grain_response(grain, yield, 1.0 / (grain.mass + yield * (grain.drag + grain.added_mass)));
}

/// Share of a change of fluid velocity over a step that drag sees, where slip would decay by exp(-x): exact where it does; 1/2 where it
/// decays slowly, the mean of start and end, which is second order in time; 1 where it decays at once.
[[nodiscard]] inline double growth_share(double x)
{
    constexpr double small = 1e-2; // below it the series is exact to 1e-12
    if (x < small) return 0.5 + x * (1.0 - x * x / 60.0) / 12.0;
    return -1.0 / std::expm1(-x) - 1.0 / x;
}

/// The same of a grain that contacts hold in part: its velocity does not follow, and a mean would let the fluid swing.
[[nodiscard]] inline double seen_share(double growth, double yield) { return 1.0 - yield * (1.0 - growth); }

/// What is owed to a grain is what it shall gain. It takes its added mass along, which the fluid has been asked for already: the force that
/// delivers it is so much larger. Contacts would take that from a grain that they hold.
[[nodiscard]] inline double delivery_factor(const GrainCoupling& grain, double yield)
{
    return 1.0 + yield * grain.added_mass / grain.mass;
}

/// Answer to a change of fluid velocity, for the predictor: that of the grain lane, where drag decays exponentially. With
/// (m / q + a) dv/dt = K (g du - dv) + a du / dt, g the share that is seen, the grain follows by dv = c (g K dt + a) du and receives
/// m dv / q.
[[nodiscard]] inline GrainResponse response_to_velocity(const GrainCoupling& grain, double yield)
{
    const double inertia = grain.mass + yield * grain.added_mass, x = yield * grain.drag / inertia;
    GrainCoupling seen = grain;
    seen.drag *= seen_share(grain.growth, yield);
    return grain_response(seen, yield, (x > 0.0 ? -std::expm1(-x) / x : 1.0) / inertia);
}

/// Answer of a cell to a change dG of the driving force density: du = velocity dG, total volume flux = mobility dG.
struct CellResponse {
    double velocity = 0.0; ///< ru [m3 s/kg]
    double mobility = 0.0; ///< coefficient of the pressure equation [m3 s/kg]
};

/// Elimination of the grains of a cell from the coupled response (symmetric: the same factor phi + entrained twice).
/// @param fluid_mass  rho phi [kg/m3].
/// @param phi         Fluid fraction [-].
/// @param sums        put() of the grains' responses with the yield of the projection; sums.flux is `entrained`.
/// @param dt          Step [s].
[[nodiscard]] inline CellResponse cell_response(double fluid_mass, double phi, const GrainResponse& sums, double dt)
{
    const double velocity = dt * (phi + sums.flux) / (fluid_mass + sums.reaction);
    return {velocity, (phi + sums.flux) * velocity + dt * sums.displaced};
}

} // namespace physics
