// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/viscosity_system.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/viscous_residual.hpp"
#include "physics/fluid/wall_profile.hpp"
#include "physics/steps/krylov_job.hpp"
#include "physics/steps/largest_rate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace physics {

ViscositySystem::ViscositySystem(const SystemContext& context, const PressureSystem& pressure, const FluidTolerances& tolerances)
    : context_(context),
      tolerances_(tolerances),
      layout_(pressure.layout()),
      workspace_(layout_, context.mesh.blocks(), std::ptrdiff_t(context.mesh.total_cells())),
      unknown_(context, layout_, "velocity change"),
      transmissibility_sum_({"transmissibility sum", "m", 0, false}, context.mesh.own_cells()),
      reciprocal_({"reciprocal of the diagonal", "1/m3", 0, false}, context.mesh.own_cells()),
      residual_({"residual of implicit velocity", "m4/s", 0, false}, context.mesh.own_cells()),
      gradient_({"gradient of implicit velocity", "1/s", 1, false}, context.mesh.own_cells()),
      flux_({"flux of implicit velocity", "m3/s", 0, false}, context.mesh.own_cells()),
      right_(layout_.size(), 0.0),
      solution_(layout_.size(), 0.0),
      sums_(3 * std::size_t(context.mesh.blocks())),
      multigrid_(context, pressure)
{
    transmissibility_sum_.allocate();
    reciprocal_.allocate();
    residual_.allocate();
    flux_.allocate();
    if (!context_.is_straight) { // else nothing reads it
        gradient_.allocate();
        context_.halos.prepare(&gradient_, core::beside);
    }
    if (context.mesh.topology().turns()) joined_ = std::make_unique<JoinedComponents>(context, layout_);
    for (core::LocalBlock b = 0; b < context.mesh.own_count(); ++b)
        transmissibility_sum(context.mesh.geometry(b), transmissibility_sum_.on(b));
}

tasks::Job ViscositySystem::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await unknown_.form_fluxes(lane, component_, in);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto result = layout_.view(b, out);
        scale_flux(context_.mesh.geometry(b), context_.viscosity_factors(b), unknown_.flux.on(b));
        net_outflow(unknown_.flux.on(b), result);
        map_cells(
            result, [d = diffusion_](double inflow, double volume, double x) { return volume * x - d * inflow; }, result,
            context_.mesh.geometry(b).volume.view(), core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0));
    });
}

tasks::Job ViscositySystem::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    if (by_multigrid_) {
        co_await multigrid_.precondition(lane, in, out);
        co_return;
    }
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            layout_.view(b, out), [](double r, double d) { return r * d; },
            core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0), reciprocal_.on(b));
    });
    co_return;
}

/// V-cycles where viscosity reaches across many cells in the step: Jacobi's preconditioner takes as many iterations.
tasks::Job ViscositySystem::choose_preconditioner(tasks::Lane& lane)
{
    double rate = 0;
    co_await find_largest_rate(lane, context_.mesh, transmissibility_sum_, rate);
    by_multigrid_ = multigrid_.pays(diffusion_ * rate);
    if (!by_multigrid_) co_return;
    multigrid_.prepare();
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto [factor, shift] = multigrid_.parts(b);
        map_faces(
            factor, [d = diffusion_](double) { return d; }, factor);
        if (const auto ratio = context_.viscosity_factors(b))
            map_faces(
                factor, [](double f, double r) { return f * r; }, factor, *ratio);
        map_cells(
            shift, [](double volume) { return volume; }, context_.mesh.geometry(b).volume.view());
        add_given_values(b, factor, shift);
    });
    co_await multigrid_.set_up(lane);
}

/// Walls and inflows hold the velocity of the cells beside them.
void ViscositySystem::add_given_values(core::LocalBlock b, core::FaceView<const double> factor, core::View<double> shift) const
{
    const auto& geometry = context_.mesh.geometry(b);
    for (const core::Side side : core::all_sides) {
        const BlockSide& at = context_.walls[std::size_t(b)].at(side);
        if (!at.gives_flux() || at.slips()) continue;
        const int axis = core::axis_of(side);
        for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
            const core::Index3 c = cell_at_face({i, j, k}, side);
            shift(c.i, c.j, c.k) += geometry.face[std::size_t(axis)].transmissibility(i, j, k) * factor.along(axis)(i, j, k);
        });
    }
}

tasks::Job ViscositySystem::form_residual(tasks::Lane& lane, const core::VectorField& change, core::VectorField& velocity, Norms& norms)
{
    ++iterations_;
    co_await context_.halos.fill(lane, &velocity, core::beside);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto& walls = context_.walls[std::size_t(b)];
        const auto u = velocity.on(b);
        mirror_velocity(walls, 1, u);
        for (int c = 0; c < 3 && !context_.is_straight; ++c)
            velocity_gradient(geometry, walls, context_.viscosity_factors(b), u.component(c), gradient_.on(b)[std::size_t(c)]);
    });
    if (!context_.is_straight) co_await context_.halos.fill(lane, &gradient_, core::beside);
    std::fill(sums_.begin(), sums_.end(), 0.0);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto volume = geometry.volume.view();
        const auto u = velocity.on(b), r = residual_.on(b);
        const auto known = change.on(b);
        ViscousSums sums;
        const core::TensorView<const double> g = context_.is_straight ? core::TensorView<const double>{} : std::as_const(gradient_).on(b);
        for (int c = 0; c < 3; ++c) {
            diffusive_inflow(geometry, context_.walls[std::size_t(b)], u.component(c), g[std::size_t(c)], context_.viscosity_factors(b),
                             {flux_.on(b), r.component(c)});
            sums += form_viscous_residual({diffusion_, volume, u.component(c), known.component(c)}, r.component(c));
        }
        const std::array parts{sums.residual, sums.change, sums.momentum};
        std::ranges::copy(parts, sums_.begin() + std::ptrdiff_t(parts.size()) * context_.mesh.global(b));
    });
    co_await lane.sum(sums_);
    std::array<double, 3> all{};
    for (std::size_t n = 0; n < sums_.size(); ++n) all[n % 3] += sums_[n];
    norms = {std::sqrt(all[0]), std::sqrt(all[1]), std::sqrt(all[2])};
}

void ViscositySystem::correct(tasks::Lane& lane, core::VectorField& velocity, core::VectorField& change) const
{
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        for (int c = 0; c < 3; ++c)
            add_jacobi_step(residual_.on(b).component(c), reciprocal_.on(b), velocity.on(b).component(c), change.on(b).component(c));
    });
}

tasks::Job ViscositySystem::solve(tasks::Lane& lane, double diffusion, core::VectorField& velocity, core::VectorField& change)
{
    constexpr double slow = 0.2;     // BiCGSTAB gains more by its two products
    constexpr double reserve = 1e-4; // what is left is a force that the books of momentum do not know
    // Iterations grow with the cells that a step diffuses across, which multigrid hides from the pressure.
    constexpr int jacobi_per_multigrid = 10;
    diffusion_ = diffusion;
    iterations_ = 0;
    Norms norms{}, before{};
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        if (const auto factors = context_.viscosity_factors(b))
            transmissibility_sum(context_.mesh.geometry(b), *factors, transmissibility_sum_.on(b));
        map_cells(
            reciprocal_.on(b), [diffusion](double volume, double sum) { return 1 / (volume + diffusion * sum); },
            context_.mesh.geometry(b).volume.view(), transmissibility_sum_.on(b));
        map_components(
            velocity.on(b), [](double w, double x) { return w + x; }, velocity.on(b), change.on(b));
    });
    co_await form_residual(lane, change, velocity, norms);
    // A change that round-off of the momentum hides is not solved for.
    const double round_off = 1e-14 * norms.momentum, target = std::max(tolerances_.viscosity * norms.change, round_off);
    const double enough = std::max(reserve * target, round_off);
    bool done = norms.residual <= enough;
    while (!done) {
        correct(lane, velocity, change);
        // The residual shrinks by the same factor again, or nearly so.
        const double factor = before.residual > 0 ? norms.residual / before.residual : 1.0;
        done = factor * norms.residual <= enough;
        if (done) break;
        before = norms;
        co_await form_residual(lane, change, velocity, norms);
        done = norms.residual <= enough;
        if (!done && !(norms.residual <= slow * before.residual)) break; // nor if it is not a number
    }
    if (done) co_return;
    co_await choose_preconditioner(lane);
    KrylovOptions options;
    options.relative = 0;
    options.absolute = joined_ ? target : target / std::sqrt(3.0);
    options.most_iterations = jacobi_per_multigrid * tolerances_.most_iterations;
    options.from_zero = true;
    options.unknown = "velocity";
    if (joined_) {
        co_await solve_joined(lane, options, velocity, change);
        co_return;
    }
    // Slip walls that lie across the axes join the components: these are then solved in turn.
    constexpr int most_turns = 50;
    for (int turn = 0; turn < most_turns; ++turn) {
        for (int c = 0; c < 3; ++c) co_await solve_component(lane, c, options, velocity, change);
        if (!context_.walls_slip) co_return;
        co_await form_residual(lane, change, velocity, norms);
        if (norms.residual <= target) co_return;
    }
    throw core::NumericsError("implicit viscosity: the components of the velocity, joined by slip walls, did not settle");
}

tasks::Job ViscositySystem::solve_joined(tasks::Lane& lane, KrylovOptions options, core::VectorField& velocity, core::VectorField& change)
{
    const JoinedComponents::Equation equation{
        diffusion_,
        [this](tasks::Lane& on, std::span<const double> right) -> tasks::Job {
            if (by_multigrid_) co_await multigrid_.expect_right(on, right);
        },
        [this](tasks::Lane& on, std::span<const double> in, std::span<double> out) { return precondition(on, in, out); }};
    co_await joined_->solve(lane, equation, options, residual_, {&velocity, &change}, iterations_);
}

tasks::Job ViscositySystem::solve_component(tasks::Lane& lane, int component, const KrylovOptions& options, core::VectorField& velocity,
                                            core::VectorField& change)
{
    component_ = component;
    std::fill(solution_.begin(), solution_.end(), 0.0);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            layout_.view(b, right_), [](double r) { return r; }, residual_.on(b).component(component));
    });
    KrylovReport report;
    if (by_multigrid_) co_await multigrid_.expect_right(lane, right_);
    co_await drive(lane, bicgstab(lane.team(), workspace_, options, right_, solution_, report), *this);
    iterations_ += 2 * report.iterations;
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        for (const auto x : {velocity.on(b).component(component), change.on(b).component(component)})
            map_cells(
                x, [](double old, double step) { return old + step; }, x, layout_.view(b, solution_));
    });
}

} // namespace physics
