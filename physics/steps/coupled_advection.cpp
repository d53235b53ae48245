// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep where fluxes through faces carry the momentum of the fluid (limited_momentum.hpp). The flux F of the fluid itself is that
// of the mixture less that of the grains. Neither that nor the new fluid fraction is known exactly before the grains have moved, and no
// mode waits for it: with phi~ what F leaves in a cell and u~ its velocity, phi u would gain (phi - phi~) u~ from nowhere. The flux f of a
// potential makes up the difference, dt sum f = V (phi~ - phi), and takes the momentum from where f comes from. The ledger has both,
//   L = - rho (phi - phi~) u~ - dt rho sum f u~_upwind / V,
// which is nothing in a uniform flow, and the sum over all cells of rho phi u V + L V changes through boundaries alone.
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/limited_momentum.hpp"
#include "physics/steps/coupled_step.hpp"
#include "physics/steps/flux_agreement.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;
using Gradients = core::TensorView<const double>;

void CoupledStep::prepare_advection()
{
    if (!fluid_.by_finite_volumes()) return;
    agreement_ = std::make_unique<FluxAgreement>(mesh_, fluid_, ranks_);
    transport_.solid.allocate();
    transport_.flux.allocate();
    halos_.prepare(&transport_.solid, core::beside);
}

void CoupledStep::find_own_flux(LocalBlock b, FaceView<const double> mixture, Vectors solid, FaceView<double> flux) const
{
    flux_of_grains(geometry(b), fluid_.walls()[std::size_t(b)], solid, flux);
    map_faces(
        flux, [](double all, double of_grains) { return all - of_grains; }, mixture, flux);
}

tasks::Job CoupledStep::find_own_flux(tasks::Lane& lane)
{
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) flux_density_of_grains(std::as_const(fields_.sums).on(b), transport_.solid.on(b));
    co_await halos_.fill(lane, &transport_.solid, core::beside);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        const auto solid = transport_.solid.on(b);
        for (int c = 0; c < 3; ++c) mirror_even(fluid_.walls()[std::size_t(b)], 1, solid.component(c));
        find_own_flux(b, std::as_const(fluid_.state()).flux.on(b), solid, transport_.flux.on(b));
    }
}

void CoupledStep::declare_advection(tasks::StageGraph& graph)
{
    if (!fluid_.by_finite_volumes()) {
        fluid_.declare_advection(graph);
        return;
    }
    fluid_.declare_source(graph);
    declare_middle(graph);
    auto& f = fluid_.fields();
    auto& t = transport_;
    graph.each_block(
        "momentum through faces between grains",
        [this](LocalBlock b, Vectors u, Vectors middle, const Gradients& g, Vectors carrier, FaceView<const double> flux,
               const FluidClock& clock, FaceView<double> x, FaceView<double> y, FaceView<double> z) {
            limited_momentum_flux({fluid_.momentum_transport(b), flux, {u, middle, g}, carrier, clock.dt}, {x, y, z});
        },
        reads(beside(fluid_.state().velocity), beside(f.middle), beside(f.velocity_gradient), beside(f.transport), f.middle_flux, clock_),
        writes(t.momentum[0], t.momentum[1], t.momentum[2]));
    graph.each_block(
        "advect velocity between grains",
        [this](LocalBlock b, Vectors u, Vectors source, View<const double> fraction, FaceView<const double> flux, FaceView<const double> x,
               FaceView<const double> y, FaceView<const double> z, const FluidClock& clock, View<double> share, VectorView<double> carried,
               VectorView<double> advected) {
            carry_momentum({geometry(b), mesh_.global(b), fraction, u, clock.dt}, flux, {x, y, z}, share, carried);
            map_components( // forces act where the fluid is, whatever flows
                advected, [](double v, double q, double before) { return v + (q - before); }, carried, source, u);
        },
        reads(fluid_.state().velocity, f.source, fields_.fraction, f.middle_flux, t.momentum[0], t.momentum[1], t.momentum[2], clock_),
        writes(t.share, t.velocity, f.advected));
}

/// In the middle of the step the fluid has what its acceleration, that of the last step, makes of it in half of it.
void CoupledStep::declare_middle(tasks::StageGraph& graph)
{
    auto& f = fluid_.fields();
    graph.each_block(
        "flux of the fluid in the middle of the step",
        [this](LocalBlock b, FaceView<const double> flux, View<const double> fraction, const FluidClock& clock, FaceView<double> before,
               FaceView<double> middle, View<double> scratch) {
            middle_flux(clock.extrapolation(), flux, before, middle);
            require_stable_outflow(largest_outflow_rate(geometry(b), middle, fraction, scratch), mesh_.global(b), clock.dt);
        },
        reads(transport_.flux, fields_.fraction, clock_), updates(fluid_.state().flux_before), writes(f.middle_flux, transport_.share));
    const auto find = [](const FluidClock& clock, Vectors transport, const Gradients& gradients, VectorView<double> out) {
        middle_velocity(clock.dt, transport, out, gradients, out);
    };
    constexpr const char* name = "velocity in the middle of the step between grains";
    if (views_.viscous())
        graph.each_block(
            name,
            [find](LocalBlock, Vectors u, Vectors acceleration, Vectors viscous, Vectors transport, const Gradients& g,
                   const FluidClock& clock, VectorView<double> out) {
                map_components(
                    out, [half = 0.5 * clock.dt](double v, double a, double s) { return v + half * (a + s); }, u, acceleration, viscous);
                find(clock, transport, g, out);
            },
            reads(fluid_.state().velocity, fields_.acceleration, f.viscous, f.transport, f.velocity_gradient, clock_), writes(f.middle));
    else
        graph.each_block(
            name,
            [find](LocalBlock, Vectors u, Vectors acceleration, Vectors transport, const Gradients& g, const FluidClock& clock,
                   VectorView<double> out) {
                map_components(
                    out, [half = 0.5 * clock.dt](double v, double a) { return v + half * a; }, u, acceleration);
                find(clock, transport, g, out);
            },
            reads(fluid_.state().velocity, fields_.acceleration, f.transport, f.velocity_gradient, clock_), writes(f.middle));
}

/// @pre Fluid fraction and ledger are those of the new state.
void CoupledStep::declare_agreement(tasks::StageGraph& graph)
{
    if (!fluid_.by_finite_volumes()) return;
    auto& t = transport_;
    graph.whole(
        "make the flux agree with the grains",
        [this](tasks::Lane& lane, const core::FaceField& flux, const core::ScalarField& before, const core::ScalarField& after,
               const FluidClock& clock, core::FaceField& rest) -> tasks::Job {
            co_await agreement_->solve(lane, {flux, before, after, clock.dt});
            lane.team().run(mesh_.own_count(), [&](int b) {
                map_faces(
                    rest.on(b), [](double) { return 0.0; }, rest.on(b));
                agreement_->add(b, rest.on(b));
            });
        },
        reads(fluid_.fields().middle_flux, fields_.fraction_before, fields_.fraction, clock_), writes(t.rest));
    graph.each_block(
        "momentum that the carrying flux owes",
        [this](LocalBlock b, FaceView<const double> rest, Vectors u, View<const double> fraction, View<const double> share,
               const FluidClock& clock, FaceView<double> x, FaceView<double> y, FaceView<double> z, VectorView<double> owed,
               VectorView<double> ledger) {
            upwind_momentum_flux(fluid_.flow_boundaries(b), rest, u, {x, y, z});
            const KnownMomentumFlux momentum{x, y, z};
            for (int c = 0; c < 3; ++c) {
                net_outflow(momentum[std::size_t(c)], owed.component(c));
                map_cells(
                    owed.component(c),
                    [dt = clock.dt, rho = parameters_.fluid_density](double out, double v, double phi, double w, double velocity) {
                        return -rho * ((phi - w) * velocity + dt * out / v);
                    },
                    owed.component(c), geometry(b).volume.view(), fraction, share, u.component(c));
                map_cells(
                    ledger.component(c), [](double l, double o) { return l + o; }, ledger.component(c), owed.component(c));
            }
        },
        reads(t.rest, beside(t.velocity), fields_.fraction, t.share, clock_), writes(t.momentum[0], t.momentum[1], t.momentum[2], t.owed),
        updates(fields_.ledger));
    graph.boundary(t.solid, "walls of flux density of grains beside momentum", [this](LocalBlock b, VectorView<double> g) {
        for (int c = 0; c < 3; ++c) mirror_even(fluid_.walls()[std::size_t(b)], 1, g.component(c));
    });
    graph.each_block(
        "flux density of grains beside momentum",
        [](LocalBlock, GrainSumViews sums, VectorView<double> out) { flux_density_of_grains(sums, out); }, reads(fields_.sums),
        writes(t.solid));
    graph.each_block(
        "volume flux of the fluid itself",
        [this](LocalBlock b, FaceView<const double> mixture, Vectors solid, FaceView<double> flux) {
            find_own_flux(b, mixture, solid, flux);
        },
        reads(fluid_.state().flux, beside(t.solid)), writes(t.flux));
    graph.sink(t.flux);
}

double CoupledStep::outflow_rate(LocalBlock b) const
{
    core::Array3<double> scratch(geometry(b).cells);
    return largest_outflow_rate(geometry(b), transport_.flux.on(b), fields_.fraction.on(b), scratch.view());
}

} // namespace physics
