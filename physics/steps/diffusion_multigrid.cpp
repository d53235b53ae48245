// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/diffusion_multigrid.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/pressure_solve.hpp"

namespace physics {

bool DiffusionMultigrid::pays(double number) const
{
    const bool uneven = context_.viscosity_ratio && context_.viscosity_ratio->used();
    return !uneven && number > 300.0; // a third of the time is saved at 200 already on small grids, but ordinary flows stay far below
}

void DiffusionMultigrid::prepare()
{
    if (solver_) return;
    solver_ = std::make_unique<SevenPointSolver>(pressure_.solver(), WithShift{});
    factor_ = std::make_unique<core::FaceField>(core::FieldInfo{"factor of diffusion", "", 0, false}, context_.mesh.own_cells());
    shift_ = std::make_unique<core::ScalarField>(core::FieldInfo{"shift of diffusion", "", 0, false}, context_.mesh.own_cells());
    factor_->allocate();
    shift_->allocate();
    link_coefficients_.resize(pressure_.links().transmissibility.size());
}

tasks::Job DiffusionMultigrid::set_up(tasks::Lane& lane)
{
    const MeshLinks& links = pressure_.links();
    for (std::size_t n = 0; n < link_coefficients_.size(); ++n) {
        const LinkFace& at = pressure_.link_faces()[n];
        const bool open = links.topology.links[n].b.block == wall_block; // where pressure is given nothing holds what diffuses
        link_coefficients_[n] = open ? 0.0 : links.transmissibility[n] * factor_->on(at.block).along(at.axis)[at.face];
    }
    lane.team().run(context_.mesh.own_count(), [&](int b) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto f = factor_->on(b).along(axis);
            map_cells(
                f, [](double factor, double t) { return factor * t; }, f,
                context_.mesh.geometry(b).face[std::size_t(axis)].transmissibility.view());
        }
    });
    co_await physics::set_up(lane, *solver_, {factor_.get(), link_coefficients_, shift_.get()});
}

tasks::Job DiffusionMultigrid::expect_right(tasks::Lane& lane, std::span<const double> right)
{
    co_await announce_right(lane, *solver_, right);
}

tasks::Job DiffusionMultigrid::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await physics::precondition(lane, *solver_, in, out);
}

} // namespace physics
