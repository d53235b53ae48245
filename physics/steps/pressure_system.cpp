// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/pressure_system.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/steps/krylov_job.hpp"
#include "physics/steps/pressure_solve.hpp"

namespace physics {

PressureSystem::PressureSystem(const SystemContext& context, const core::Communicator& ranks, const FluidTolerances& tolerances)
    : context_(context),
      links_(make_mesh_links(context.mesh, ranks.rank(),
                             [&](const core::Boundary& boundary) {
                                 return context.walls[std::size_t(context.mesh.local(boundary.block))].at(boundary.side).gives_pressure();
                             })),
      link_faces_(physics::link_faces(context.mesh, links_)),
      solver_(links_.topology, {.singular = !context.pressure_is_given}, ranks),
      unknown_(context, solver_.layout(), "pressure change"),
      coefficients_({"mobile transmissibility", "", 0, false}, context.mesh.own_cells()),
      link_coefficients_(links_.transmissibility),
      right_(solver_.layout().size(), 0.0),
      solution_(solver_.layout().size(), 0.0),
      norms_(context.mesh, tolerances, !context.pressure_is_given)
{
    coefficients_.allocate();
}

tasks::Job PressureSystem::load(tasks::Lane& lane)
{
    loaded_ = false;
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        transmissibility(context_.mesh.geometry(b), coefficients_.on(b));
        if (mobility_)
            map_faces(
                coefficients_.on(b), [](double t, double m) { return t * m; }, coefficients_.on(b), mobility_->on(b));
    });
    for (std::size_t n = 0; n < link_faces_.size(); ++n) {
        const LinkFace& at = link_faces_[n];
        link_coefficients_[n] = links_.transmissibility[n] * (mobility_ ? mobility_->on(at.block).along(at.axis)[at.face] : 1.0);
    }
    co_await set_up(lane, solver_, {&coefficients_, link_coefficients_, nullptr});
    loaded_ = !mobility_;
}

tasks::Job PressureSystem::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await unknown_.form_fluxes(lane, std::nullopt, in);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        if (mobility_) scale_by_mobility(context_.mesh.geometry(b), mobility_->on(b), unknown_.flux.on(b));
        const auto outflow = solver_.layout().view(b, out);
        net_outflow(unknown_.flux.on(b), outflow);
        map_cells(
            outflow, [](double x) { return -x; }, outflow);
    });
}

tasks::Job PressureSystem::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await physics::precondition(lane, solver_, in, out);
}

tasks::Job PressureSystem::solve(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi)
{
    mobility_ = nullptr;
    if (!loaded_) co_await load(lane);
    co_await solve_loaded(lane, fluxes, psi);
}

tasks::Job PressureSystem::solve(tasks::Lane& lane, const core::FaceField& mobility, FluxesToProject fluxes, core::ScalarField& change)
{
    mobility_ = &mobility;
    co_await load(lane);
    co_await solve_loaded(lane, fluxes, change);
}

tasks::Job PressureSystem::solve_again(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi)
{
    const int before = report_.iterations;
    co_await solve_loaded(lane, fluxes, psi);
    report_.iterations += before;
}

tasks::Job PressureSystem::take_off(tasks::Lane& lane, const core::ScalarField& psi, core::FaceField& flux)
{
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            solver_.layout().view(b, solution_), [](double x) { return x; }, psi.on(b));
    });
    co_await unknown_.form_fluxes(lane, std::nullopt, solution_);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        if (mobility_) scale_by_mobility(context_.mesh.geometry(b), mobility_->on(b), unknown_.flux.on(b));
        map_faces(
            flux.on(b), [](double f, double g) { return f - g; }, flux.on(b), unknown_.flux.on(b));
    });
}

tasks::Job PressureSystem::solve_loaded(tasks::Lane& lane, FluxesToProject fluxes, core::ScalarField& psi)
{
    co_await norms_.gather(lane, fluxes.outflow, fluxes.throughput);
    solver_.expect_right(norms_.outflow());
    const BlockLayout& layout = solver_.layout();
    std::fill(solution_.begin(), solution_.end(), 0.0);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            layout.view(b, right_), [](double x) { return -x; }, fluxes.outflow.on(b));
    });
    report_ = {};
    const KrylovOptions options = norms_.options(fluxes.share);
    if (context_.is_straight) co_await physics::solve(lane, solver_, options, right_, solution_, report_); // that is the full operator
    else co_await drive(lane, bicgstab(lane.team(), solver_.workspace(), options, right_, solution_, report_), *this);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            psi.on(b), [](double x) { return x; }, layout.view(b, solution_));
    });
}

} // namespace physics
