// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/fluid_step.hpp"
#include "core/comm/reduce.hpp"
#include "physics/fluid/advection_lcsi.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/transposed_stress.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::halo, tasks::reads, tasks::updates, tasks::writes;

namespace {

bool all_straight(const core::Mesh& mesh, const core::Communicator& ranks)
{
    return core::max_over_blocks(mesh, ranks, [&](LocalBlock b) { return mesh.geometry(b).is_straight() ? 0.0 : 1.0; }) < 1.0;
}

} // namespace

FluidStep::FluidStep(const core::Mesh& mesh, const core::Communicator& ranks, tasks::HaloFiller& halos, const FluidParameters& parameters)
    : mesh_(mesh),
      halos_(halos),
      parameters_(parameters),
      walls_(make_walls(mesh, parameters.boundaries)),
      state_(mesh),
      fields_(mesh),
      clock_("fluid clock", state_.clock),
      drive_("drive", state_.clock.drive),
      is_straight_(all_straight(mesh, ranks)),
      pressure_system_(system_context(), ranks, parameters.tolerances),
      budget_("momentum budget", std::size_t(mesh.own_count()))
{
    require_balance(ranks);
    const auto& conditions = parameters_.boundaries;
    if (std::any_of(conditions.begin(), conditions.end(),
                    [](const auto& said) { return !std::holds_alternative<SteadyCourse>(said.second.course); })) {
        full_walls_ = walls_before_ = walls_;
        begin_step();
    }
    if (parameters_.viscosity > 0)
        viscosity_system_ = std::make_unique<ViscositySystem>(system_context(), pressure_system_, parameters_.tolerances);
    if (const auto* flow = std::get_if<FlowDrive>(&parameters_.drive))
        flow_control_ =
            std::make_unique<FlowControl>(system_context(), *flow, pressure_system_, parameters_.tolerances, parameters_.viscosity);
    prepare_advection();
    state_.velocity.allocate();
    state_.velocity_before.allocate();
    state_.pressure.allocate();
    state_.flux.allocate();
}

void FluidStep::require_balance(const core::Communicator& ranks) const
{
    if (any_boundary(mesh_, parameters_.boundaries, gives_pressure)) return;
    std::vector<TimeCourse> courses{SteadyCourse{}};
    for (const auto& [name, said] : parameters_.boundaries)
        if (std::find(courses.begin(), courses.end(), said.course) == courses.end()) courses.push_back(said.course);
    // At all times: the boundaries of each course must balance by themselves.
    for (const TimeCourse& course : courses) {
        std::vector<BlockWalls> walls = walls_;
        for (BlockWalls& block : walls)
            for (BlockSide& side : block.sides)
                if (side.course != course) side.velocity = SideVectors();
        const auto sum = [&](double GivenFlux::*part) {
            return core::sum_over_blocks(mesh_, ranks, [&](LocalBlock b) { return given_flux(geometry(b), walls[std::size_t(b)]).*part; });
        };
        const double net = sum(&GivenFlux::net), all = sum(&GivenFlux::largest);
        constexpr double round_off = 1e-9; // of grids read from files in single precision, over what flows in and out
        core::require<core::ConfigError>(std::abs(net) <= round_off * all,
                                         core::text(std::abs(net), net > 0 ? " m3/s more flow out of" : " m3/s more flow into",
                                                    " the domain than the other way", courses.size() > 1 ? " at some time" : "",
                                                    ", and no boundary gives way: let one be an outflow"));
    }
}

void FluidStep::begin_step()
{
    set_time(full_walls_, state_.clock.time, walls_before_);
    set_time(full_walls_, state_.clock.time + state_.clock.dt, walls_);
}

SystemContext FluidStep::system_context() const
{
    const auto any = [this](auto holds) { return any_boundary(mesh_, parameters_.boundaries, holds); };
    return {mesh_, walls_, halos_, any(gives_pressure), any(slips), &fields_.viscosity_ratio, is_straight_};
}

void FluidStep::declare(tasks::StageGraph& graph)
{
    const auto lane = graph.lane("fluid");
    declare_boundaries(graph);
    declare_expected_drive(graph);
    declare_pressure_gradient(graph);
    declare_velocity_gradients(graph);
    if (viscosity_system_) declare_viscous_acceleration(graph, fields_.viscous);
    declare_transport(graph);
    declare_predictor(graph);
    declare_projection(graph);
}

void FluidStep::declare_expected_drive(tasks::StageGraph& graph)
{
    if (flow_control_) flow_control_->declare_expected(graph, state_.flux, clock_, drive_);
}

void FluidStep::declare_pressure_gradient(tasks::StageGraph& graph)
{
    graph.each_block(
        "gradient of pressure",
        [this](LocalBlock b, View<const double> p, VectorView<double> gp) {
            gradient(geometry(b), pressure_matrices(geometry(b), walls_of(b)), p, gp);
        },
        reads(beside(state_.pressure)), writes(fields_.pressure_gradient));
}

void FluidStep::declare_transport(tasks::StageGraph& graph)
{
    graph.each_block(
        "transport velocity",
        [this](LocalBlock b, FaceView<const double> flux, VectorView<double> out) { transport_velocity(geometry(b), flux, out); },
        reads(state_.flux), writes(fields_.transport));
}

void FluidStep::declare_predictor(tasks::StageGraph& graph)
{
    auto& f = fields_;
    declare_advection(graph);
    graph.each_block(
        "predict velocity",
        [this](LocalBlock, Vectors advected, Vectors gp, const FluidClock& clock, const DriveState& state, VectorView<double> predicted) {
            const core::Vec3 drive = expected_acceleration(parameters_.drive, state, clock.time, clock.dt);
            const double half = 0.5 * clock.dt / parameters_.density;
            for (int c = 0; c < 3; ++c)
                map_cells(
                    predicted.component(c), [half, gain = clock.dt * drive[c]](double u, double g) { return u + (gain - half * g); },
                    advected.component(c), gp.component(c));
        },
        reads(f.advected, f.pressure_gradient, clock_, drive_), writes(f.predicted));
    declare_viscous_guess(graph);
    declare_implicit_viscosity(graph);
    if (flow_control_) flow_control_->declare_response(graph, f.viscosity_ratio, clock_);
}

void FluidStep::declare_boundaries(tasks::StageGraph& graph)
{
    const int layers = by_finite_volumes() ? 1 : 3; // stencils from departure points are wider
    if (full_walls_.empty()) {
        graph.boundary(state_.velocity, "walls of velocity",
                       [this, layers](LocalBlock b, VectorView<double> u) { mirror_velocity(walls_of(b), layers, u); });
    } else {
        graph.whole(
            "start of step", [](tasks::Lane&, Moment& moment) { moment = Moment::start; }, writes(moment_));
        graph.boundary(
            state_.velocity, "walls of velocity at its time",
            [this, layers](LocalBlock b, VectorView<double> u, const Moment& moment) { mirror_velocity(walls_at(moment, b), layers, u); },
            reads(moment_));
    }
    graph.boundary(state_.velocity_before, "walls of velocity before",
                   [this](LocalBlock b, VectorView<double> u) { mirror_velocity(old_walls_of(b), 1, u); });
    graph.boundary(fields_.transport, "walls of transport velocity",
                   [this](LocalBlock b, VectorView<double> u) { mirror_velocity(old_walls_of(b), 1, u); });
    graph.boundary(fields_.predicted, "walls of predicted velocity",
                   [this](LocalBlock b, VectorView<double> u) { mirror_velocity(walls_of(b), 1, u); });
    graph.boundary(state_.pressure, "walls of pressure", [this](LocalBlock b, View<double> p) { mirror_pressure(walls_of(b), 1, p); });
    graph.boundary(fields_.psi, "walls of pressure impulse",
                   [this](LocalBlock b, View<double> p) { mirror_pressure_change(walls_of(b), 1, p); });
    graph.boundary(fields_.pressure_gradient, "walls of pressure gradient", [this](LocalBlock b, VectorView<double> g) {
        for (int c = 0; c < 3; ++c) mirror_even(walls_of(b), 1, g.component(c));
    });
    graph.boundary(
        fields_.source, "walls of velocity to advect",
        [this](LocalBlock b, VectorView<double> q, Vectors u) { mirror_source(walls_of(b), 3, u, q); }, reads(halo(state_.velocity, 3)));
}

void FluidStep::declare_end_of_step(tasks::StageGraph& graph)
{
    if (full_walls_.empty()) return;
    graph.whole(
        "end of step", [](tasks::Lane&, Moment& moment) { moment = Moment::end; }, updates(moment_));
}

void FluidStep::declare_viscous_guess(tasks::StageGraph& graph)
{
    if (!viscosity_system_) return;
    auto& f = fields_;
    graph.each_block(
        "guess of viscous change",
        [](LocalBlock, Vectors viscous, const FluidClock& clock, VectorView<double> change) {
            map_components(
                change, [step = clock.implicit_share() * clock.dt](double a) { return step * a; }, viscous);
        },
        reads(f.viscous, clock_), writes(f.viscous_change));
}

void FluidStep::declare_implicit_viscosity(tasks::StageGraph& graph)
{
    if (!viscosity_system_) return;
    auto& f = fields_;
    // What the Laplacian leaves out is known: it goes to the right-hand side, and belongs to what viscosity changes.
    const auto add_known = [&](const char* name, core::VectorField& to) {
        if (!f.viscosity_ratio.used()) return;
        graph.each_block(
            name,
            [this](LocalBlock b, const Gradients& g, const FaceFactors& ratio, const FluidClock& clock, FaceView<double> scratch,
                   VectorView<double> out) {
                const TransposedStress stress{geometry(b), walls_of(b), parameters_.viscosity, g, *ratio};
                add_transposed_stress(stress, clock.implicit_share() * clock.dt, scratch, out);
            },
            reads(beside(f.velocity_gradient), f.viscosity_ratio, clock_), writes(f.face_scratch), updates(to));
    };
    add_known("transposed turbulent stress", f.predicted);
    graph.whole(
        "implicit viscosity",
        [this](tasks::Lane& lane, const FluidClock& clock, const ViscosityRatio&, core::VectorField& change, core::VectorField& predicted) {
            return viscosity_system_->solve(lane, clock.implicit_share() * clock.dt * parameters_.viscosity, predicted, change);
        },
        reads(clock_, f.viscosity_ratio), updates(f.viscous_change, f.predicted));
    add_known("change by transposed turbulent stress", f.viscous_change);
}

} // namespace physics
