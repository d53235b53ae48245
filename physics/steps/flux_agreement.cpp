// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/flux_agreement.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/projection.hpp"

namespace physics {

FluxAgreement::FluxAgreement(const core::Mesh& mesh, const FluidStep& fluid, const core::Communicator& ranks)
    : mesh_(mesh),
      context_(fluid.system_context()),
      system_(context_, ranks, fluid.parameters().tolerances),
      outflow_({"net outflow of the fluid alone", "m3/s", 0, false}, mesh.own_cells()),
      through_({"throughput of the fluid alone", "m3/s", 0, false}, mesh.own_cells()),
      psi_({"potential of the fluid alone", "m2/s", 1, false}, mesh.own_cells()),
      gradient_({"gradient of the potential of the fluid alone", "m/s", 1, false}, mesh.own_cells()),
      scratch_({"correction of the flux of the fluid alone", "m3/s", 0, false}, mesh.own_cells())
{
    for (core::ScalarField* field : {&outflow_, &through_, &psi_}) field->allocate();
    gradient_.allocate();
    scratch_.allocate();
    context_.halos.prepare(&psi_, core::beside);
    context_.halos.prepare(&gradient_, core::beside);
}

tasks::Job FluxAgreement::solve(tasks::Lane& lane, Change change)
{
    constexpr double volume_counts = 1e-3; // what is left of a disagreement may be that share of the tolerance of a cell's volume
    lane.team().run(mesh_.own_count(), [&](int b) {
        const auto volume = mesh_.geometry(b).volume.view();
        net_outflow(change.flux.on(b), outflow_.on(b));
        throughput(change.flux.on(b), through_.on(b));
        map_cells(
            outflow_.on(b), [dt = change.dt](double out, double v, double phi, double w) { return out + v * (phi - w) / dt; },
            outflow_.on(b), volume, change.after.on(b), change.before.on(b));
        map_cells(
            through_.on(b), [per = volume_counts / change.dt](double through, double v) { return through + per * v; }, through_.on(b),
            volume);
    });
    co_await system_.solve(lane, {outflow_, through_, 1.0}, psi_);
    co_await context_.halos.fill(lane, &psi_, core::beside);
    lane.team().run(mesh_.own_count(), [&](int b) {
        const BlockWalls& walls = context_.walls[std::size_t(b)];
        mirror_pressure_change(walls, 1, psi_.on(b));
        gradient(mesh_.geometry(b), pressure_matrices(mesh_.geometry(b), walls), psi_.on(b), gradient_.on(b));
    });
    co_await context_.halos.fill(lane, &gradient_, core::beside);
}

void FluxAgreement::add(core::LocalBlock b, core::FaceView<double> flux)
{
    correct_flux(mesh_.geometry(b), context_.walls[std::size_t(b)], psi_.on(b), gradient_.on(b), scratch_.on(b), flux);
}

} // namespace physics
