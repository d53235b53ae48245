// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/mode.hpp"

#include "core/base/error.hpp"
#include <algorithm>

namespace physics {

namespace {

// Measured in the one-cell model (tests/verification/coupling): grains that stick and slip make `concurrent` grow from
// b = 10 on; only grains clamped and released at random make `pipelined` and `coarse` overshoot, four times at b = 10 and
// without bound from b = 100 on: `auto` stays below that, a user who asks for them may go to b = 50 (a real bed holds there).
constexpr double stiff_for_concurrent = 2.0;
constexpr double stiff_for_auto = 5.0;
constexpr double stiff_for_pipelined = 50.0;
constexpr double quiet_amplification = 0.3;
constexpr double dilute = 0.1;
// A bed whose springs are so soft that drag carries it along through the whole step sways with its fluid like a mass on a spring. In
// a single pass each takes the other for what it was at the start of the step; that feeds the sway by (w dt)^2 / 4 in each step,
// with w^2 = k / (fluid mass of a grain), and drag takes k dt / (2 K) of it: unstable from b M = 2 on, and measured from 1 on where
// what is owed comes later. Stiffer springs, K / (k dt) < 0.3, are at rest within the step.
constexpr double swaying_exchange = 0.5;
constexpr double swaying_softness_coarse = 0.05;
// The more the fluid takes of it, the stiffer the springs must be. Measured of beds of 2 mm grains in oils: at b M = 5.7 one of 0.07
// comes to rest and one of 0.10 sways for ever, at b M = 11.6 one of 0.07 does and one of 0.14 does not, at 2.7 one of 0.21 does.
constexpr double swaying_exchange_much = 3.0;
constexpr double swaying_softness_much = 0.07;
constexpr double swaying_exchange_iterated = 2.0; // of three passes with the hold by the load; measured: 3
// A grain's sub-step takes about a tenth of a microsecond, a cell's step 1.4: from here on the grains take as long as half of the
// fluid, and not to wait for them is worth a second sum over them.
constexpr double long_wait = 7.0;

/// Softness up to which a bed is at rest within a step; @param softness  where the fluid takes little.
double resting_softness(const StabilityNumbers& n, double softness)
{
    return n.stiffness * n.loading > swaying_exchange_much ? std::min(softness, swaying_softness_much) : softness;
}

bool sways(const StabilityNumbers& n, double softness)
{
    return n.stiffness * n.loading > swaying_exchange && n.softness > resting_softness(n, softness);
}

bool concurrent_holds(const StabilityNumbers& n)
{
    return n.stiffness <= stiff_for_concurrent && (n.amplification < quiet_amplification || n.solid_fraction < dilute);
}

} // namespace

bool holds(Mode mode, const StabilityNumbers& n)
{
    if (mode == Mode::iterated) return true;
    if (sways(n, mode == Mode::coarse ? swaying_softness_coarse : swaying_softness)) return false;
    return mode == Mode::concurrent ? concurrent_holds(n) : n.stiffness <= stiff_for_pipelined;
}

double added_mass_amplification(double phi, double density_ratio, double added_mass_coefficient)
{
    const double added = added_mass_coefficient;
    return (1.0 - phi) * (1.0 / phi + added / (phi * phi) + added / phi) / (density_ratio + added);
}

bool gives_way(double exchange, double softness) { return exchange > swaying_exchange_iterated && softness > swaying_softness; }

double coupling_number(const StabilityNumbers& numbers) { return numbers.stiffness * numbers.loading / (1.0 + numbers.loading); }

const char* name(Mode mode)
{
    switch (mode) {
    case Mode::pipelined: return "pipelined";
    case Mode::coarse: return "coarse";
    case Mode::concurrent: return "concurrent";
    case Mode::iterated: return "iterated";
    }
    return "unknown";
}

ModeChoice choose_mode(const StabilityNumbers& n)
{
    const std::string numbers =
        core::text("b = ", n.stiffness, ", M = ", n.loading, ", A = ", n.amplification, ", C = ", n.solid_fraction,
                   ", K/(k dt) = ", n.softness, ", b M/(1+M) = ", coupling_number(n), ", sub-steps of grains per cell ", n.grain_work);
    if (n.stiffness > stiff_for_auto) {
        return {Mode::iterated, core::text("iterated: drag is too stiff for one pass (b > ", stiff_for_auto, "); ", numbers)};
    }
    if (sways(n, swaying_softness)) {
        return {Mode::iterated, core::text("iterated: the springs of the bed are too soft against drag for one pass (K/(k dt) > ",
                                           resting_softness(n, swaying_softness), " and b M > ", swaying_exchange,
                                           "), it would sway ever more; shorter steps or a higher "
                                           "contact.stiffness need one; ",
                                           numbers)};
    }
    if (!concurrent_holds(n) || n.solid_fraction >= dilute) {
        return {Mode::pipelined,
                core::text("pipelined: drag is soft enough for one pass, but so many grains press on each other and on the fluid that "
                           "it needs their real state ('coarse' holds too, for a third more work of the grains); ",
                           numbers)};
    }
    if (n.grain_work < long_wait) {
        return {Mode::pipelined,
                core::text("pipelined: 'concurrent' would hold (soft drag, few grains), but there is little to wait for; ", numbers)};
    }
    return {Mode::concurrent,
            core::text("concurrent: soft drag and few grains with much work, the fluid need not wait for them; ", numbers)};
}

ModeChoice mode_of_step(std::optional<Mode> asked, const StabilityNumbers& numbers, std::int64_t step)
{
    if (asked == Mode::iterated) return {Mode::iterated, "iterated: as the scene asks"};
    if (step == 0) return {Mode::iterated, "iterated: the first step knows no pressure yet"};
    const ModeChoice best = choose_mode(numbers);
    if (asked && holds(*asked, numbers)) return {*asked, core::text(name(*asked), ": as the scene asks")};
    if (asked) return {Mode::iterated, core::text("iterated: '", name(*asked), "' is unstable in this state; ", best.reason)};
    return best;
}

} // namespace physics
