// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The grains' side of the exchange: the load that the fluid puts on each grain before the sub-steps, what each grain did
// with it, and what it is still owed afterwards (steps 2, 3 and 6 of response.hpp).
#include "physics/coupling/exchange_fields.hpp"
#include "physics/coupling/grain_holds.hpp"
#include "physics/coupling/grid_spread.hpp"
#include "physics/coupling/parameters.hpp"
#include "physics/particles/newton.hpp"

namespace physics {

struct SpinInput;

/// Columns of the particle set that the exchange keeps through the sub-steps of one fluid step. Each name is the first of
/// three columns unless it says otherwise.
struct ExchangeColumns {
    int owed;            ///< impulse still owed [N s]; carried from step to step
    int delivered;       ///< what this step delivers of it [N s]
    int told;            ///< acceleration of the fluid that entered its added-mass force [m/s2]; carried
    int hold;            ///< one column: hold of the last step [-]; carried
    int untold;          ///< what was kept back of the acceleration, times dt [m/s]
    int velocity_before; ///< [m/s]
    int spin_before;     ///< [1/s]
    int known_force;     ///< what the sub-steps apply and the fluid does not feel the reaction of: weight, pressure, what is owed [N]
    int force_used;      ///< B G^n [N/m3]
    int extra_force;     ///< of FluidForce::material_derivative, carried from step to step [N]; -1 without
    int drag;            ///< one column: K [kg/s]
    int drag_before;     ///< one column: K at the start of the last step, 0 before the first; carried [kg/s]
    int yield, growth;   ///< one column each: 1 - hold of the last step, share of a change that drag sees (response.hpp) [-]
    int smooth;          ///< one column: how far what changes in time is extrapolated to the middle of a step, 0 to 1 [-]
    int velocity_used;   ///< filtered velocity where the sub-steps begin [m/s]
    int velocity_first;  ///< the same in the first pass, without the grain's own wake [m/s]
    int added_mass;      ///< one column [kg]
    int wake;            ///< what it adds to the velocity it samples (own_disturbance.hpp), carried [m/s]; -1 without
    int fluctuation;     ///< turbulent velocity it meets over its standard deviation (dispersion.hpp), carried [-]; -1 without
    int fluctuation_met; ///< mean of that velocity over the step [m/s]; -1 without
    int history;         ///< the first of history_columns, carried (history_force.hpp); -1 without
};
[[nodiscard]] ExchangeColumns add_exchange_columns(core::ParticleSet& grains, const CouplingParameters& parameters);

/// Three components of a HistoryMemory, one after the other, and the length of the last step [s].
inline constexpr int history_columns = 43;

/// What drag depends on beside the slip, for each owned grain.
struct GrainSurroundings {
    std::vector<double> fraction;   ///< phi [-]
    std::vector<double> surface;    ///< sum of V / d per volume; empty unless sizes are mixed [1/m]
    std::vector<GridSpread> spread; ///< of hats and cells; empty unless the own disturbance is taken off
};

/// What a step is to the grains.
struct GrainStep {
    double dt;             ///< of the fluid [s]
    double sub_step;       ///< of the grains [s]
    double before = 0.0;   ///< length of the step before; 0 before the first [s]
    double delivery = 1.0; ///< share of what is owed that is delivered; less than all in steps shorter than those before
};

/// What a step is to turbulence that grains meet.
struct GrainStirring {
    double dt;            ///< [s]
    std::uint64_t number; ///< of the step: no two draw the same
};

/// Values at the grains: one column for each array of a batch, and a spare one.
using GrainTable = std::vector<std::vector<double>>;

class GrainExchange {
public:
    GrainExchange(const CouplingParameters& parameters, WetColumns wet, ExchangeColumns columns)
        : parameters_(parameters), wet_(wet), columns_(columns)
    {
    }
    [[nodiscard]] const WetColumns& wet_columns() const { return wet_; }
    [[nodiscard]] const ExchangeColumns& columns() const { return columns_; }

    /// Velocity that each grain's own wake adds where it samples, grown over `dt` from what it was [m/s].
    /// @pre the own disturbance is taken off
    /// @param views  grain_views columns sampled at the grains.
    [[nodiscard]] std::vector<core::Vec3> wakes(const core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around,
                                                double dt) const;
    /// Takes wakes off what was sampled, and each grain's own volume off the solid fraction.
    void take_off(const std::vector<core::Vec3>& wakes, const core::ParticleSet& grains, GrainTable& views,
                  GrainSurroundings& around) const;
    void remember_wakes(core::ParticleSet& grains, const std::vector<core::Vec3>& wakes) const;

    [[nodiscard]] bool disperses() const { return parameters_.dispersion; }
    /// Draws the turbulent velocity that each grain meets in a step. @pre dispersion
    /// @param views  Of the views the velocity suffices. @param turbulence  SeenOfTurbulence columns sampled at the grains.
    void stir(core::ParticleSet& grains, const GrainTable& views, const GrainTable& turbulence, const GrainStirring& step) const;
    /// Adds it to the velocity that was sampled, if the grains meet any.
    void add_fluctuations(const core::ParticleSet& grains, GrainTable& views) const;

    /// Before anything is taken off: the velocity that a pass tells. @param views  As freeze_drag().
    void remember_told(core::ParticleSet& grains, const GrainTable& views) const;

    /// Step 2: drag coefficients and added masses of all owned grains, for the whole step.
    /// @param views  grain_views columns sampled at the grains.
    void freeze_drag(core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around, const GrainStep& step) const;

    /// Step 2: loads of all owned grains.
    /// @param drive  Mean acceleration of the fluid by the drive over the step [m/s2].
    void load(core::ParticleSet& grains, const GrainTable& views, const core::Vec3& drive, const GrainStep& step) const;

    /// What each owned grain sets against turbulence (turbulence_damping.hpp): drag coefficient, and mass with added mass.
    [[nodiscard]] GrainTable resistance(const core::ParticleSet& grains) const;

    /// Before a pass is repeated, when the views are of its own step: nothing need be kept back from held grains, and where slip relaxes
    /// fast K becomes the mean of what it was and what the new slip asks for.
    void revise(core::ParticleSet& grains, const GrainTable& views, const GrainSurroundings& around) const;

    /// Step 3: what contacts and all else did to each owned grain.
    [[nodiscard]] std::vector<GrainImpulses> impulses(const core::ParticleSet& grains) const;

    /// What grains were told and did.
    struct Told {
        const GrainTable& views; ///< of the step or pass, sampled where the grains are now
        const GrainHolds& holds;
        double dt; ///< [s]
    };
    /// Step 3: what each grain deposits; grain_sums columns.
    /// @param told  Of the views the velocity suffices.
    void answer(const core::ParticleSet& grains, const Told& told, GrainTable& deposits) const;

    /// Step 6: what each grain is owed, with what has not been delivered. All columns are sampled at the new positions.
    /// @param told  What the last pass began with. Filter and sampling are linear: changes are differences of `news` and `told`.
    /// @param news  grain_news columns.
    void owe(core::ParticleSet& grains, const Told& told, const GrainTable& news) const;

    /// K / m, K that of the last step or, before the first, of a grain that settles in the fluid fraction `fraction` [1/s].
    [[nodiscard]] double drag_rate(const core::ParticleSet& grains, int g, double fraction) const;
    [[nodiscard]] static double volume(const core::ParticleSet& grains, int g);
    /// Columns of `deposits`, and arrays of their sums, that are not zero throughout.
    [[nodiscard]] std::size_t sums() const { return parameters_.added_mass > 0 || parameters_.history ? grain_sums : sum_added; }
    /// Angular impulse that the fluid's torque gave grain g in the last step [N m s]; the model takes it from nobody.
    [[nodiscard]] core::Vec3 couple(const core::ParticleSet& grains, int g) const;

private:
    [[nodiscard]] GrainCoupling coupling_of(const core::ParticleSet& grains, int g, double dt) const;
    [[nodiscard]] std::vector<double> drags(const core::ParticleSet& grains, const GrainTable& views,
                                            const GrainSurroundings& around) const;
    /// All but contacts, drag, added mass and what is known, of grain g [N].
    [[nodiscard]] core::Vec3 lift(const SpinInput& in) const;
    /// Of all that is past, mean over the step [N].
    [[nodiscard]] core::Vec3 history(const core::ParticleSet& grains, int g, double dt) const;
    void remember(core::ParticleSet& grains, int g, double dt) const;
    [[nodiscard]] double relaxation(const core::ParticleSet& grains, int g, double fraction, double impulse_per_slip) const;
    [[nodiscard]] core::Vec3 tell(core::ParticleSet& grains, int g, const core::Vec3& acceleration, double dt) const;
    [[nodiscard]] GrainImpulses impulses_of(const core::ParticleSet& grains, int g) const;
    /// What material_derivative adds to the pressure force, half of it from the step before.
    [[nodiscard]] core::Vec3 extra_force(core::ParticleSet& grains, int g, const core::Vec3& per_volume) const;
    [[nodiscard]] core::Vec3 column(const core::ParticleSet& grains, int first, int g) const;

    CouplingParameters parameters_;
    WetColumns wet_;
    ExchangeColumns columns_;
};

} // namespace physics
