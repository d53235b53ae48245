// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/pressure_system.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/steps/krylov_job.hpp"
#include "physics/steps/pressure_solve.hpp"

namespace physics {
namespace {

/// The transmissibilities of the mesh as the multigrid wants them.
void set_up(const core::Mesh& mesh, int rank, SevenPointSolver& solver)
{
    core::FaceField faces({"transmissibility", "m", 0, false}, mesh.own_cells());
    faces.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        for (int axis = 0; axis < 3; ++axis)
            map_cells(faces.on(b).along(axis), [](double t) { return t; }, mesh.geometry(b).face[std::size_t(axis)].transmissibility.view());
    const MeshLinks links = make_mesh_links(mesh, rank, BehindWalls::nothing);
    solver.set_up(core::SerialTeam(), {&faces, links.transmissibility, nullptr});
}

} // namespace

PressureSystem::PressureSystem(const SystemContext& context, const core::Communicator& ranks, const FluidTolerances& tolerances)
    : context_(context),
      solver_(make_mesh_links(context.mesh, ranks.rank(), BehindWalls::nothing).topology, MultigridOptions{}, ranks),
      unknown_(context, solver_.layout(), "pressure impulse"), right_(solver_.layout().size(), 0.0),
      solution_(solver_.layout().size(), 0.0), norms_(context.mesh, tolerances)
{
    set_up(context.mesh, ranks.rank(), solver_);
}

tasks::Job PressureSystem::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await unknown_.form_fluxes(lane, BehindWalls::nothing, in);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto outflow = solver_.layout().view(b, out);
        net_outflow(unknown_.flux.on(b), outflow);
        map_cells(outflow, [](double x) { return -x; }, outflow);
    });
}

tasks::Job PressureSystem::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await physics::precondition(lane, solver_, in, out);
}

tasks::Job PressureSystem::solve(tasks::Lane& lane, double share, const core::ScalarField& outflow, const core::ScalarField& throughput,
                                 core::ScalarField& psi)
{
    const BlockLayout& layout = solver_.layout();
    std::fill(solution_.begin(), solution_.end(), 0.0);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(layout.view(b, right_), [](double x) { return -x; }, outflow.on(b));
    });
    co_await norms_.gather(lane, outflow, throughput);
    solver_.expect_right(norms_.outflow());
    report_ = {};
    co_await drive(lane, bicgstab(lane.team(), solver_.workspace(), norms_.options(share), right_, solution_, report_), *this);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(psi.on(b), [](double x) { return x; }, layout.view(b, solution_));
    });
}

} // namespace physics
