// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What grains see of the fluid: the filtered state that they are told, and its answer when it has made its step.
#include "core/comm/halo.hpp"
#include "physics/coupling/cell_exchange.hpp"
#include "physics/coupling/grain_exchange.hpp"
#include "physics/particles/dynamics.hpp"
#include "physics/steps/fluid_step.hpp"
#include "physics/steps/lane_filter.hpp"

namespace physics {

class FluidViews {
public:
    /// All references must outlive the views; `fields` has what they read and write. Collective.
    FluidViews(const core::Mesh& mesh, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid, ExchangeFields& fields,
               const CouplingParameters& parameters);

    /// Tells the present state, of which all is found anew. Collective.
    [[nodiscard]] tasks::Job tell_state(tasks::Lane& lane, Filter& filter);

    /// Hands the fluid the viscous acceleration of the old velocity, found when the last step told the grains of it.
    void declare_viscosity(tasks::StageGraph& graph);
    /// For grains that it turns or lifts.
    void declare_vorticity(tasks::StageGraph& graph);
    /// For grains that a model of turbulence disperses; before anything is declared.
    void see_turbulence(core::ScalarField& k, core::ScalarField& epsilon);
    /// The new state as the grains see it.
    void declare_state(tasks::StageGraph& graph);
    /// Is the viscous stress that of the new state, or still what grains have been told?
    enum class Stress { as_told, of_new_state };
    /// What is told of the gradients of velocity, and the filter over all that the grains will sample.
    void declare_filtered(tasks::StageGraph& graph, LaneFilter& filter, Stress stress);
    /// The answer becomes what the next pass, or the next step, tells the grains.
    void declare_told(tasks::StageGraph& graph, Stress stress);

    /// One column for each array of the batches.
    template <class... Batches>
    [[nodiscard]] GrainTable sample(const core::Team& team, const GrainPlaces& places, std::size_t grains, const Batches&... batches) const
    {
        GrainTable table((Batches::arrays + ...), std::vector<double>(grains));
        team.run(mesh_.own_count(), [&](int b) {
            std::size_t column = 0;
            const auto add = [&](const auto& fields) {
                places.sample(b, fields, std::span(table).subspan(column, fields.size()));
                column += fields.size();
            };
            (add(batches.on(b)), ...);
        });
        return table;
    }
    /// The grains of a step, and where and how they are when they have moved.
    struct GrainLane {
        const GrainExchange& exchange;
        tasks::Part<ParticleDynamics>& grains;
        tasks::Value<GrainPlaces>& places;
        tasks::Value<GrainHolds>& holds;
        tasks::Part<FluidClock>& clock;
    };
    /// Draws the turbulent velocity that each grain meets in the step, where one is seen.
    void declare_stirring(tasks::StageGraph& graph, const GrainLane& lane);
    /// Grains are owed what the answer is beyond what they were told: step 6 of response.hpp.
    void declare_owed(tasks::StageGraph& graph, const GrainLane& lane);

    [[nodiscard]] bool viscous() const { return fluid_.viscosity_system() != nullptr; }
    /// Between cells and places of grains.
    [[nodiscard]] const core::HaloExchange& plan() const { return plan_; }

private:
    void view_state(core::LocalBlock b, CellVectors u, core::View<const double> p, CellVectors acceleration,
                    std::span<const core::View<double>> out) const;
    void add_correction(const DriveState& drive, GrainTable& views) const;
    void view_stress_in(std::span<const core::View<double>> out, CellVectors viscous) const;
    [[nodiscard]] bool tells_stress(Stress stress) const { return viscous() && stress == Stress::of_new_state; }

    [[nodiscard]] tasks::Job find_turbulence(tasks::Lane& lane, const core::ScalarField& k, const core::ScalarField& epsilon,
                                             core::FieldBatch<seen_of_turbulence>& seen);

    const core::Mesh& mesh_;
    tasks::HaloFiller& halos_;
    FluidStep& fluid_;
    ExchangeFields& fields_;
    bool spins_; ///< Do grains see vorticity?
    core::HaloExchange plan_;
    core::ScalarField *k_ = nullptr, *epsilon_ = nullptr; ///< of turbulence that disperses grains
};

} // namespace physics
