// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluid and grains in one step, coupled both ways: the algorithm of physics/coupling/response.hpp as stages.
#include "physics/coupling/cell_exchange.hpp"
#include "physics/coupling/transport_fields.hpp"
#include "physics/fluid/mobility.hpp"
#include "physics/particles/stepper.hpp"
#include "physics/steps/fluid_views.hpp"
#include "physics/steps/flux_agreement.hpp"
#include "physics/steps/step_company.hpp"
#include <limits>
#include <memory>

namespace physics {

/// Passes of the mode `iterated`.
inline constexpr int passes_of_iterated = 3;

class CoupledStep {
public:
    /// All references must outlive the step. Collective.
    CoupledStep(const core::Locator& locator, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
                ParticleDynamics& grains, ParticleStepper& stepper, const CouplingParameters& parameters);
    CoupledStep(const CoupledStep&) = delete;
    CoupledStep& operator=(const CoupledStep&) = delete;

    void keep_company(StepCompany company) { company_ = std::move(company); }
    /// Declares all stages, those of the fluid included. May be called for several graphs, of which each step runs one.
    /// @pre At the start of a step no rank has lists of neighbours (see grain_job.hpp): a repeated pass could not restore them.
    void declare(tasks::StageGraph& graph, Mode mode);
    /// Finds the grains among the cells, sets the fluid fraction and what the grains are told: to be called whenever the state
    /// was set from outside. Collective.
    [[nodiscard]] tasks::Job initialise(tasks::Lane& lane);
    /// The first part of initialise(): enough for stability(), and no graph need be compiled. Collective.
    [[nodiscard]] tasks::Job find_fraction(tasks::Lane& lane);

    [[nodiscard]] ExchangeFields& fields() { return fields_; }
    /// Makes the steps find what grains set against turbulence; before anything is declared.
    void resist_turbulence() { resists_turbulence_ = true; }
    /// Of finite-volume advection.
    [[nodiscard]] const TransportFields& transport() const { return transport_; }
    /// The largest share of the fluid of a cell that leaves it in a time [1/s]. @pre Finite-volume advection.
    [[nodiscard]] double outflow_rate(core::LocalBlock b) const;
    [[nodiscard]] const GrainExchange& exchange() const { return exchange_; }
    /// What grains see of the fluid.
    [[nodiscard]] FluidViews& views() { return views_; }
    /// Extremes of the present state on this rank, for steps of `dt` [s]; the drag is that of the last step, before the first that
    /// of grains that settle.
    /// @param bed_stiffness  Of bed_stiffness.hpp [N/m].
    [[nodiscard]] StabilityNumbers stability(double dt, double bed_stiffness = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] int filter_degree() const { return filter_.own.degree(); }
    /// Sub-steps of the grains in the step that is being made; set it together with the clock's dt = sub_steps * sub-step.
    int sub_steps = 1;
    /// Is this a step of a bed that gives way (mode.hpp)?
    bool bed_gives_way = false;

private:
    void declare_boundaries(tasks::StageGraph& graph);
    void declare_sizes(tasks::StageGraph& graph);
    void declare_surface(tasks::StageGraph& graph);
    [[nodiscard]] tasks::Job sum_surface(tasks::Lane& lane, const core::ParticleSet& grains, const GrainPlaces& places, Filter& filter,
                                         core::FieldBatch<1>& surface);
    void declare_grain_load(tasks::StageGraph& graph);
    void declare_resistance(tasks::StageGraph& graph);
    void declare_restart_of_grains(tasks::StageGraph& graph);
    void declare_grain_sums(tasks::StageGraph& graph);
    void declare_memory_of_contacts(tasks::StageGraph& graph);
    void declare_transport(tasks::StageGraph& graph);
    void prepare_advection();
    void find_own_flux(core::LocalBlock b, core::FaceView<const double> mixture, CellVectors solid, core::FaceView<double> flux) const;
    tasks::Job find_own_flux(tasks::Lane& lane);
    void declare_advection(tasks::StageGraph& graph);
    void declare_middle(tasks::StageGraph& graph);
    void declare_agreement(tasks::StageGraph& graph);
    void declare_memory(tasks::StageGraph& graph);
    void declare_expected(tasks::StageGraph& graph);
    void declare_expected_again(tasks::StageGraph& graph);
    void declare_advected(tasks::StageGraph& graph);
    void make_assumed();
    void declare_taking(tasks::StageGraph& graph);
    void declare_assumed(tasks::StageGraph& graph, Mode mode);
    void declare_ledger(tasks::StageGraph& graph, Mode mode);
    void declare_predictor(tasks::StageGraph& graph, core::FieldBatch<grain_sums>& taken);
    void declare_volume_flux(tasks::StageGraph& graph, core::FieldBatch<grain_sums>& taken);
    void declare_projection(tasks::StageGraph& graph);
    void declare_correction(tasks::StageGraph& graph);
    void declare_fraction(tasks::StageGraph& graph);
    /// The last pass of a step is followed by another step, which begins with the viscous stress.
    enum class Pass { followed, last };
    void declare_answer(tasks::StageGraph& graph, Mode mode, Pass pass);
    [[nodiscard]] static FluidViews::Stress stress_of(Pass pass)
    {
        return pass == Pass::last ? FluidViews::Stress::of_new_state : FluidViews::Stress::as_told;
    }

    /// Grains after the sub-steps, and what they were told.
    struct MovedGrains {
        const core::ParticleSet& grains;
        const core::FieldBatch<told_views>& told;
        double dt;           ///< [s]
        GrainPlaces& places; ///< found
        GrainHolds& holds;   ///< found
    };
    [[nodiscard]] tasks::Job sum_over_grains(tasks::Lane& lane, MovedGrains moved, Filter& filter, core::FieldBatch<grain_sums>& sums);
    struct GrainState {
        core::ParticleSet particles;
        core::ContactHistory history;
    };
    /// What a fluid lane that does not wait takes the grains for.
    struct AssumedGrains {
        std::unique_ptr<ParticleDynamics> dynamics;
        std::unique_ptr<ParticleStepper> stepper;
        GrainPlaces places;
        GrainHolds holds;
    };
    [[nodiscard]] tasks::Job coarse_pass(tasks::Lane& lane, AssumedGrains& assumed, double time) const;
    [[nodiscard]] GrainSurroundings surroundings(const GrainPlaces& places, const core::ParticleSet& grains,
                                                 const core::ScalarField& fraction) const;
    /// What the step begins with and the grains are told [m/s2].
    [[nodiscard]] core::Vec3 drive_of(const FluidClock& clock, const DriveState& state) const;
    /// Time and drive of a step.
    struct StepDrive {
        const FluidClock& clock;
        const DriveState& state;
    };
    [[nodiscard]] FluidOwn own(CellVectors velocity, CellVectors advected, CellVectors pressure_gradient, const StepDrive& at) const;
    [[nodiscard]] const core::BlockGeometry& geometry(core::LocalBlock b) const { return mesh_.geometry(b); }

    const core::Mesh& mesh_;
    const core::Communicator& ranks_;
    FluidStep& fluid_;
    ParticleDynamics& dynamics_;
    ParticleStepper& stepper_;
    CouplingParameters parameters_;
    const core::Locator& locator_;
    tasks::HaloFiller& halos_;
    ExchangeFields fields_;
    FluidViews views_;
    TransportFields transport_;
    std::unique_ptr<FluxAgreement> agreement_; ///< with finite-volume advection alone
    GrainExchange exchange_;
    StepCompany company_;
    bool resists_turbulence_ = false;
    LaneFilter filter_;                        ///< of the grain lane
    std::unique_ptr<LaneFilter> fluid_filter_; ///< of a fluid lane that does not wait for the grains
    core::FaceField face_mobility_, known_face_mobility_;
    tasks::Part<ParticleDynamics> grains_;
    tasks::Part<FluidClock> clock_;
    tasks::Value<GrainPlaces> places_;
    tasks::Value<GrainHolds> holds_;
    tasks::Value<std::vector<double>> surface_; ///< of the grains around each grain; empty unless sizes are mixed [1/m]
    tasks::Value<GrainState> kept_;             ///< loaded, before the first sub-step: where a repeated pass begins
    tasks::Value<AssumedGrains> assumed_;       ///< empty unless a mode needs them
};

} // namespace physics
