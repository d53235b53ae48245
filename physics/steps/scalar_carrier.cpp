// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/scalar_carrier.hpp"
#include "physics/fluid/advection_lcsi.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/largest_rate.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

core::FieldInfo scratch(const char* name, int halo) { return {name, "", halo, false}; }

} // namespace

ScalarCarrier::ScalarCarrier(const SystemContext& context)
    : context_(context),
      velocity_(scratch("velocity of the carrier", 1), context.mesh.own_cells()),
      gradient_(scratch("gradient of a scalar", 1), context.mesh.own_cells()),
      half_(scratch("scalar in the middle of a step", 1), context.mesh.own_cells()),
      gain_(scratch("gain of a scalar", 1), context.mesh.own_cells()),
      loss_(scratch("loss of a scalar", 1), context.mesh.own_cells()),
      next_share_(scratch("next share of the carrier", 0), context.mesh.own_cells()),
      capacity_(scratch("capacity for a scalar", 0), context.mesh.own_cells()),
      low_(scratch("upwind scalar", 0), context.mesh.own_cells()),
      net_(scratch("net outflow of a scalar", 0), context.mesh.own_cells()),
      upwind_(scratch("upwind flux of a scalar", 0), context.mesh.own_cells()),
      added_(scratch("added flux of a scalar", 0), context.mesh.own_cells())
{
    for (const core::BlockId b : context.mesh.own()) centres_.push_back(face_centres(context.mesh.vertices(b)));
    for (core::VectorField* field : {&velocity_, &gradient_}) field->allocate();
    for (core::ScalarField* field : {&half_, &gain_, &loss_, &next_share_, &capacity_, &low_, &net_}) field->allocate();
    for (core::FaceField* field : {&upwind_, &added_}) field->allocate();
    context_.halos.prepare(&gradient_, core::beside);
    context_.halos.prepare(&half_, core::beside);
}

void set_entering(const BlockWalls& walls, const EntryValues& entering, core::View<double> value)
{
    mirror_even(walls, 1, value);
    for (const core::Side side : core::all_sides)
        if (const auto given = entering[std::size_t(side)])
            for_each_side_face(value.extents(), side, [&](int i, int j, int k) {
                core::Index3 beyond{i, j, k};
                if (!core::is_high(side)) beyond[core::axis_of(side)] = -1;
                value[beyond] = *given;
            });
}

tasks::Job ScalarCarrier::count_parts(tasks::Lane& lane, const Flow& flow)
{
    constexpr double most_outflow = 0.8; // of the fluid in a cell; bounds hold to 1
    for_blocks(lane, [&](core::LocalBlock b) { outflow_of_cells(geometry(b), flow.flux.on(b), net_.on(b)); });
    double rate = 0;
    co_await find_largest_rate(lane, context_.mesh, net_, flow.share, rate);
    parts_ = std::max(1, int(std::ceil(flow.dt * rate / most_outflow)));
}

void ScalarCarrier::begin_part(tasks::Lane& lane, const Flow& flow, double dt)
{
    for_blocks(lane, [&](core::LocalBlock b) {
        transport_velocity(geometry(b), flow.flux.on(b), velocity_.on(b));
        net_outflow(flow.flux.on(b), net_.on(b));
        const auto volume = geometry(b).volume.view();
        map_cells(
            next_share_.on(b), [dt](double w, double out, double v) { return w - dt * out / v; }, flow.share.on(b), net_.on(b), volume);
        map_cells(
            capacity_.on(b), [dt](double w, double v) { return w * v / dt; }, next_share_.on(b), volume);
    });
}

void ScalarCarrier::predict(core::LocalBlock b, const Flow& flow, double dt, const CarriedScalar& scalar)
{
    const auto q = scalar.value->on(b);
    mirror_even(context_.walls[std::size_t(b)], 1, q);
    gradient(geometry(b), geometry(b).gradient, q, gradient_.on(b));
    middle_of_step(dt, flow.share.on(b), velocity_.on(b), q, gradient_.on(b), half_.on(b));
    set_entering(context_.walls[std::size_t(b)], scalar.entering[std::size_t(b)], q);
}

void ScalarCarrier::step_upwind(core::LocalBlock b, const Flow& flow, const CarriedScalar& scalar)
{
    const auto q = scalar.value->on(b);
    const auto added = added_.on(b);
    transport_fluxes(geometry(b), centres_[std::size_t(b)], flow.flux.on(b), {q, half_.on(b), gradient_.on(b)}, upwind_.on(b), added);
    close_boundaries(context_.walls[std::size_t(b)], added); // what enters and leaves has the upwind value
    net_outflow(upwind_.on(b), low_.on(b));
    // In terms of what differs from the cell's own value: round-off does not grow with that.
    map_cells(
        low_.on(b), [](double out, double net, double room, double x) { return x - (out - net * x) / room; }, low_.on(b), net_.on(b),
        capacity_.on(b), q);
    flux_shares(geometry(b), q, low_.on(b), capacity_.on(b), added, gain_.on(b), loss_.on(b));
}

tasks::Job ScalarCarrier::carry(tasks::Lane& lane, const Flow& flow, double dt, const CarriedScalar& scalar)
{
    co_await context_.halos.fill(lane, scalar.value, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) { predict(b, flow, dt, scalar); });
    co_await context_.halos.fill(lane, &gradient_, core::beside);
    co_await context_.halos.fill(lane, &half_, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) { step_upwind(b, flow, scalar); });
    co_await context_.halos.fill(lane, &gain_, core::beside);
    co_await context_.halos.fill(lane, &loss_, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        reduce_fluxes(geometry(b), gain_.on(b), loss_.on(b), added_.on(b));
        const auto out = half_.on(b); // no longer needed
        net_outflow(added_.on(b), out);
        map_cells(
            scalar.value->on(b), [](double q, double a, double room) { return q - a / room; }, low_.on(b), out, capacity_.on(b));
    });
}

tasks::Job ScalarCarrier::carry(tasks::Lane& lane, Flow flow, std::span<const CarriedScalar> scalars)
{
    co_await count_parts(lane, flow);
    const double dt = flow.dt / parts_;
    for (int part = 0; part < parts_; ++part) {
        begin_part(lane, flow, dt);
        for (const CarriedScalar& scalar : scalars) co_await carry(lane, flow, dt, scalar);
        for_blocks(lane, [&](core::LocalBlock b) {
            map_cells(
                flow.share.on(b), [](double w) { return w; }, next_share_.on(b));
        });
    }
}

} // namespace physics
