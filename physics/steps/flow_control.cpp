// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/flow_control.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;

namespace {

std::vector<BlockWalls> at_rest(std::vector<BlockWalls> walls)
{
    for (BlockWalls& block : walls)
        for (BlockSide& side : block.sides) side.velocity = SideVectors();
    return walls;
}

/// The flux of a uniform vector through all faces but those of boundaries, times a mobility.
void uniform_flux(const core::BlockGeometry& geometry, const core::Vec3& vector, FaceView<const double> mobility, FaceView<double> flux)
{
    for (int axis = 0; axis < 3; ++axis) {
        const core::FaceMetrics& face = geometry.face[std::size_t(axis)];
        map_cells(
            flux.along(axis),
            [&](double m, double x, double y, double z) { return m * (vector.x() * x + vector.y() * y + vector.z() * z); },
            mobility.along(axis), face.area_x.view(), face.area_y.view(), face.area_z.view());
    }
    sub_face_uniform_flux(geometry, vector, mobility, flux);
}

} // namespace

FlowControl::FlowControl(const SystemContext& context, const FlowDrive& drive, PressureSystem& pressure, const FluidTolerances& tolerances,
                         double viscosity)
    : context_{context},
      walls_at_rest_(at_rest(context.walls)),
      drive_(drive),
      pressure_(pressure),
      section_(context.mesh, drive.direction),
      viscosity_(viscosity),
      response_({"response to the drive", "s", 1, false, true}, context.mesh.own_cells()),
      response_change_({"viscous part of the response to the drive", "s", 0, false}, context.mesh.own_cells()),
      response_flux_({"flux of the response to the drive", "", 0, false}, context.mesh.own_cells()),
      trial_flux_({"flux before the drive is corrected", "m3/s", 0, false}, context.mesh.own_cells()),
      outflow_({"outflow of the response to the drive", "m3/s", 0, false}, context.mesh.own_cells()),
      change_({"pressure of the response to the drive", "", 0, false}, context.mesh.own_cells()),
      sums_(2 * std::size_t(context.mesh.blocks()))
{
    outflow_.allocate();
    change_.allocate();
    if (viscosity <= 0) return;
    const SystemContext& c = context_;
    const SystemContext resting{c.mesh, walls_at_rest_, c.halos, c.pressure_is_given, c.walls_slip, c.viscosity_ratio, c.is_straight};
    viscosity_system_ = std::make_unique<ViscositySystem>(resting, pressure, tolerances);
    response_change_.allocate();
}

void FlowControl::declare_expected(tasks::StageGraph& graph, core::FaceField& flux, tasks::Part<FluidClock>& clock,
                                   tasks::Part<DriveState>& drive)
{
    graph.whole(
        "expected drive",
        [this](tasks::Lane& lane, const core::FaceField& old, const FluidClock& now, DriveState& state) -> tasks::Job {
            std::array<double, 2> flow{};
            co_await measure(lane, old, old, flow);
            state.flow = flow[0];
            state.expected = state.resistance + (target(now.time + now.dt) - state.flow) / (section_.mean_area() * now.dt);
            state.correction = 0;
        },
        reads(flux, clock), updates(drive));
}

void FlowControl::declare_next_pass(tasks::StageGraph& graph, tasks::Part<DriveState>& drive)
{
    graph.whole(
        "drive of the last pass",
        [](tasks::Lane&, DriveState& state) {
            state.expected += state.correction;
            state.correction = 0;
        },
        updates(drive));
}

void FlowControl::declare_response(tasks::StageGraph& graph, ViscosityRatio& ratio, tasks::Part<FluidClock>& clock)
{
    graph.boundary(response_, "walls of the response to the drive",
                   [this](LocalBlock b, VectorView<double> w) { mirror_velocity(walls_at_rest_[std::size_t(b)], 1, w); });
    graph.whole(
        "response to the drive",
        [this](tasks::Lane& lane, const FluidClock& now, const ViscosityRatio& factors, core::VectorField& response) {
            return find_response(lane, now, factors, response);
        },
        reads(clock, ratio), updates(response_));
    graph.each_block(
        "flux of the response to the drive",
        [this](LocalBlock b, VectorView<const double> w, FaceView<double> flux) {
            interpolated_flux(context_.mesh.geometry(b), walls_at_rest_[std::size_t(b)], w, flux);
        },
        reads(beside(response_)), writes(response_flux_));
}

tasks::Job FlowControl::find_response(tasks::Lane& lane, const FluidClock& clock, const ViscosityRatio& ratio, core::VectorField& response)
{
    const Known wanted{clock.dt, clock.implicit_share()};
    if (wanted == known_ && !ratio.used()) co_return;
    known_ = {};
    for_blocks(lane, [&](LocalBlock b) {
        for (int c = 0; c < 3; ++c)
            map_cells(
                response.on(b).component(c), [gain = clock.dt * drive_.direction[c]](double) { return gain; }, response.on(b).component(c));
    });
    if (viscosity_system_) {
        for_blocks(lane, [&](LocalBlock b) {
            map_components(
                response_change_.on(b), [](double) { return 0.0; }, response_change_.on(b));
        });
        co_await viscosity_system_->solve(lane, clock.implicit_share() * clock.dt * viscosity_, response, response_change_);
    }
    known_ = wanted;
}

void FlowControl::declare_response(tasks::StageGraph& graph, core::FaceField& mobility)
{
    graph.each_block(
        "flux of the response to a gradient",
        [this](LocalBlock b, FaceView<const double> m, FaceView<double> flux) {
            uniform_flux(context_.mesh.geometry(b), drive_.direction, m, flux);
            close_boundaries(context_.walls[std::size_t(b)], flux);
        },
        reads(mobility), writes(response_flux_));
}

void FlowControl::declare_correction(tasks::StageGraph& graph, Projection p)
{
    graph.whole(
        "flow as prescribed",
        [this, per_unit = p.acceleration_per_unit](tasks::Lane& lane, const core::FaceField& response, const core::ScalarField& throughput,
                                                   const FluidClock& clock, core::FaceField& trial, core::ScalarField& psi,
                                                   core::FaceField& flux, DriveState& state) -> tasks::Job {
            double units = 0;
            co_await correct(lane, {response, throughput, clock, trial, psi, flux}, units);
            state.correction = units * per_unit;
            const double change = target(clock.time + clock.dt) - state.flow;
            state.resistance = state.expected + state.correction - change / (section_.mean_area() * clock.dt);
        },
        reads(response_flux_, p.throughput, p.clock), writes(trial_flux_), updates(p.psi, p.flux, p.drive));
}

tasks::Job FlowControl::correct(tasks::Lane& lane, Parts p, double& units)
{
    for_blocks(lane, [&](LocalBlock b) {
        map_faces(
            p.trial.on(b), [](double f) { return f; }, std::as_const(p.flux).on(b));
    });
    co_await pressure_.take_off(lane, p.psi, p.trial);
    std::array<double, 2> flow{};
    co_await measure(lane, p.trial, p.response, flow);
    const double missing = target(p.clock.time + p.clock.dt) - flow[0];
    if (missing == 0) co_return;
    const double guess = missing / flow[1];
    for_blocks(lane, [&](LocalBlock b) {
        map_faces(
            p.trial.on(b), [guess](double f) { return guess * f; }, p.response.on(b));
        net_outflow(std::as_const(p.trial).on(b), outflow_.on(b));
    });
    co_await pressure_.solve_again(lane, {outflow_, p.throughput, 1.0 - p.clock.memory()}, change_);
    co_await pressure_.take_off(lane, change_, p.trial);
    co_await measure(lane, p.trial, p.trial, flow);
    const double scale = missing / flow[0];
    units = scale * guess;
    for_blocks(lane, [&](LocalBlock b) {
        map_cells(
            p.psi.on(b), [scale](double s, double d) { return s + scale * d; }, p.psi.on(b), change_.on(b));
        map_faces(
            p.flux.on(b), [units](double f, double r) { return f + units * r; }, p.flux.on(b), p.response.on(b));
    });
}

void FlowControl::declare_gain(tasks::StageGraph& graph, core::VectorField& predicted, tasks::Part<DriveState>& drive)
{
    graph.each_block(
        "velocity gained by the drive",
        [](LocalBlock, VectorView<const double> response, const DriveState& state, VectorView<double> u) {
            map_components(
                u, [c = state.correction](double v, double w) { return v + c * w; }, u, response);
        },
        reads(response_, drive), updates(predicted));
}

tasks::Job FlowControl::measure(tasks::Lane& lane, const core::FaceField& first, const core::FaceField& second,
                                std::array<double, 2>& found)
{
    std::fill(sums_.begin(), sums_.end(), 0.0);
    for_blocks(lane, [&](LocalBlock b) {
        const auto at = 2 * std::size_t(context_.mesh.global(b));
        sums_[at] = section_.through(b, first.on(b));
        sums_[at + 1] = section_.through(b, second.on(b));
    });
    co_await lane.sum(sums_);
    found = {};
    for (std::size_t n = 0; n < sums_.size(); ++n) found[n % 2] += sums_[n];
}

} // namespace physics
