// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene come to life on this rank: mesh, fluid, grains, their coupling, and the graph of the stages that make a step.
// What the scene does not name is not there.
#include "io/build/contact_builder.hpp"
#include "io/build/grain_census.hpp"
#include "io/run/grain_traffic.hpp"
#include "io/run/state_copy.hpp"
#include "physics/fluid/time_step.hpp"
#include "physics/steps/coupled_step.hpp"
#include "physics/steps/one_way_step.hpp"
#include "physics/steps/scalar_step.hpp"
#include "physics/steps/turbulence_step.hpp"
#include "tasks/exchange_filler.hpp"
#include "tasks/executor.hpp"
#include <functional>
#include <map>
#include <set>

namespace io {

class World {
public:
    /// Collective. @throws core::ConfigError for a scene that cannot be computed.
    World(const Scene& scene, const core::Communicator& ranks);
    /// The same with the blocks of the scene's grid, made before.
    World(const Scene& scene, core::MultiBlock blocks, const core::Communicator& ranks);
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const core::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const core::Communicator& ranks() const { return ranks_; }
    [[nodiscard]] physics::FluidStep* fluid() { return fluid_ ? &*fluid_ : nullptr; }
    [[nodiscard]] const physics::FluidStep* fluid() const { return fluid_ ? &*fluid_ : nullptr; }
    [[nodiscard]] physics::TurbulenceStep* turbulence() { return turbulence_ ? &*turbulence_ : nullptr; }
    [[nodiscard]] const physics::TurbulenceStep* turbulence() const { return turbulence_ ? &*turbulence_ : nullptr; }
    [[nodiscard]] physics::ScalarStep* scalars() { return scalars_ ? &*scalars_ : nullptr; }
    [[nodiscard]] const physics::ScalarStep* scalars() const { return scalars_ ? &*scalars_ : nullptr; }
    [[nodiscard]] physics::ParticleDynamics* grains() { return grains_ ? &*grains_ : nullptr; }
    [[nodiscard]] const physics::ParticleDynamics* grains() const { return grains_ ? &*grains_ : nullptr; }
    /// Where fluid and grains feel each other.
    [[nodiscard]] physics::CoupledStep* coupling() { return coupling_ ? &*coupling_ : nullptr; }
    [[nodiscard]] const physics::CoupledStep* coupling() const { return coupling_ ? &*coupling_ : nullptr; }
    /// Where grains feel a fluid that does not feel them.
    [[nodiscard]] physics::OneWayStep* one_way() { return one_way_ ? &*one_way_ : nullptr; }
    [[nodiscard]] const physics::OneWayStep* one_way() const { return one_way_ ? &*one_way_ : nullptr; }
    /// What grains keep of the fluid either way; none without both.
    [[nodiscard]] const physics::GrainExchange* exchange() const
    {
        return coupling_ ? &coupling_->exchange() : one_way_ ? &one_way_->exchange() : nullptr;
    }

    /// How many grains of which sizes there were at the start, or may come in.
    [[nodiscard]] const GrainCensus& census() const { return census_; }
    /// The account of grains that came in and were taken away; none without grains.
    [[nodiscard]] GrainTraffic* traffic() { return traffic_ ? &*traffic_ : nullptr; }
    [[nodiscard]] const GrainTraffic* traffic() const { return traffic_ ? &*traffic_ : nullptr; }
    /// Calls `after` whenever grains have come or gone, before a step.
    void watch_traffic(std::function<void()> after) { after_traffic_ = std::move(after); }

    [[nodiscard]] double time() const { return clock().time; }
    [[nodiscard]] const physics::FluidClock& clock() const { return fluid_ ? fluid_->state().clock : dry_clock_; }
    [[nodiscard]] physics::FluidClock& clock() { return fluid_ ? fluid_->state().clock : dry_clock_; }
    /// Sub-steps of the grains in the last step; 0 without grains.
    [[nodiscard]] int sub_steps() const { return sub_steps_; }
    /// Why the coupling of the last step had its mode, or what is expected before the first; empty without coupling.
    [[nodiscard]] const std::string& mode_reason() const { return mode_reason_; }
    /// How steps run whose mode is not that of the plan: the first, and those for which another is better.
    void run_other_modes_with(const tasks::ExecutorOptions& options) { other_options_ = options; }

    /// The cell that holds a position relative to the domain's origin [m].
    [[nodiscard]] std::optional<core::Location> location_of(const core::Vec3& position) const;
    /// The rank that owns what lies at a position relative to the domain's origin [m]; the same on all ranks.
    [[nodiscard]] int owner_of(const core::Vec3& position) const;

    /// Grains alone, with their weight in the fluid, for what is left of scene.run.settle. Collective.
    void settle(const core::Team& team);
    /// A part of it; the parts do not depend on where a run was interrupted. Collective.
    void settle_batch(const core::Team& team);
    /// Sub-steps that are left of it.
    [[nodiscard]] double settling_left() const;
    /// Sub-steps of it that are done: part of the state.
    [[nodiscard]] double& settled() { return settled_; }
    /// Compiles the stages; call once, after settle() or after the state has been read. Collective.
    const tasks::Plan& compile();
    /// None before compile().
    [[nodiscard]] const tasks::Plan* plan() const { return plan_ ? &*plan_ : nullptr; }
    /// One step of at most the time that the limits allow; one that fails is tried again with half the time, unless the
    /// scene fixes it. Collective.
    /// @throws tasks::StepFailure, core::NumericsError on all ranks alike; the state is then that before the step.
    void step(tasks::Executor& executor);
    /// Makes the next step no longer than this share of what the limits allow; a failed step does the same by halves.
    void shorten_next_step(double share) { shortening_ = share; }
    /// How many steps were made by which mode since the state was made or read; empty without coupling.
    [[nodiscard]] std::string mode_counts() const;
    /// Modes that `auto` has begun to use since the last call, and why.
    [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }
    /// Why steps had to be repeated, or coupled by a safer mode, since the last call.
    [[nodiscard]] std::vector<std::string> take_warnings() { return std::exchange(warnings_, {}); }
    /// The length of the next step [s]. Collective.
    [[nodiscard]] double next_step();
    /// Which limit next_step() found to be the tightest.
    [[nodiscard]] const std::string& step_limit() const { return limit_name_; }
    /// Speed along the drive on the axis of the domain [m/s]. Collective.
    [[nodiscard]] double axis_speed() const;

private:
    void make_grains();
    void make_coupling();
    void make_company();
    [[nodiscard]] physics::StepCompany company();
    void declare();
    [[nodiscard]] tasks::Layout layout() const;
    [[nodiscard]] physics::StabilityNumbers stability(double dt) const;
    void plan_mode();
    [[nodiscard]] physics::Mode choose_mode();
    struct OtherMode {
        OtherMode(const tasks::Layout& layout, const core::Communicator& ranks) : graph(layout, ranks) {}
        tasks::StageGraph graph;
        std::optional<tasks::Plan> plan;
        std::unique_ptr<tasks::Executor> executor;
    };
    OtherMode& add_mode(physics::Mode mode);
    [[nodiscard]] tasks::Executor& executor_of(physics::Mode mode);
    void try_step(tasks::Executor& executor);
    void pass_grains();
    void put_back();
    void initialise();
    [[nodiscard]] physics::TransportRates transport_rates(const core::Vec3& pull) const;
    [[nodiscard]] physics::TimeStepLimit limit_of_step() const;
    /// Divides a step of at most dt [s] into sub-steps of the grains: whole ones that contacts ask for, or a single shorter one.
    /// @returns its length [s].
    double divided(double dt);
    void set_sub_step(double step);

    Scene scene_;
    GrainCensus census_;
    BedContact bed_contact_;
    core::Communicator ranks_;
    core::Mesh mesh_;
    core::Locator locator_;
    tasks::ExchangeFiller halos_;
    tasks::StageGraph graph_;
    std::optional<physics::FluidStep> fluid_;
    std::optional<physics::TurbulenceStep> turbulence_;
    std::optional<physics::ScalarStep> scalars_;
    std::optional<physics::ParticleDynamics> grains_;
    std::optional<physics::ParticleStepper> stepper_;
    std::optional<GrainTraffic> traffic_;
    std::function<void()> after_traffic_;
    std::optional<physics::CoupledStep> coupling_;
    std::optional<physics::OneWayStep> one_way_;
    std::optional<tasks::Part<physics::ParticleDynamics>> dry_grains_;
    std::optional<tasks::Plan> plan_;
    physics::FluidClock dry_clock_; ///< of a scene without fluid
    std::optional<core::Location> axis_;
    std::optional<physics::Mode> asked_mode_;
    physics::Mode planned_mode_ = physics::Mode::pipelined;
    std::string mode_reason_;
    std::map<physics::Mode, std::int64_t> steps_of_mode_;
    std::set<physics::Mode> told_modes_; ///< to the user
    bool told_of_soft_springs_ = false;
    std::map<physics::Mode, OtherMode> others_;
    tasks::ExecutorOptions other_options_{.kind = "serial"};
    double settled_ = 0;
    int sub_steps_ = 0;
    double contact_step_ = 0; ///< the longest sub-step of the grains that resolves their contacts [s]
    std::string limit_name_;  ///< of the last step
    double shortening_ = 1.0; ///< of the step that is being tried again
    StateCopy before_;
    std::vector<std::string> warnings_, notes_;
};

} // namespace io
