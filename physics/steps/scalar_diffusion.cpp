// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/scalar_diffusion.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/diffusion.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/krylov_job.hpp"
#include "physics/steps/largest_rate.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

core::FieldInfo scratch(const char* name, int halo) { return {name, "", halo, false}; }

} // namespace

ScalarDiffusion::ScalarDiffusion(const SystemContext& context, const PressureSystem& pressure)
    : context_(context),
      layout_(pressure.layout()),
      workspace_(layout_, context.mesh.blocks(), std::ptrdiff_t(context.mesh.total_cells())),
      change_(scratch("change of a scalar", 1), context.mesh.own_cells()),
      inflow_(scratch("diffusive inflow of a scalar", 0), context.mesh.own_cells()),
      diagonal_(scratch("diagonal of diffusion", 0), context.mesh.own_cells()),
      right_(scratch("right-hand side of a scalar", 0), context.mesh.own_cells()),
      gradient_(scratch("gradient of a diffusing scalar", 1), context.mesh.own_cells()),
      flux_(scratch("diffusive flux of a scalar", 0), context.mesh.own_cells()),
      residual_(layout_.size(), 0.0),
      solution_(layout_.size(), 0.0),
      multigrid_(context, pressure)
{
    for (core::ScalarField* field : {&change_, &inflow_, &diagonal_, &right_}) field->allocate();
    gradient_.allocate();
    flux_.allocate();
    context_.halos.prepare(&change_, core::beside);
    context_.halos.prepare(&gradient_, core::beside);
}

tasks::Job ScalarDiffusion::form_inflow(tasks::Lane& lane, core::ScalarField& q)
{
    ++products_;
    co_await context_.halos.fill(lane, &q, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        mirror_even(context_.walls[std::size_t(b)], 1, q.on(b));
        gradient(geometry(b), geometry(b).gradient, q.on(b), gradient_.on(b));
    });
    co_await context_.halos.fill(lane, &gradient_, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto flux = flux_.on(b);
        gradient_flux(geometry(b), q.on(b), gradient_.on(b), flux);
        close_boundaries(context_.walls[std::size_t(b)], flux);
        scale_flux(geometry(b), equation_->diffusivity.on(b), flux);
        net_outflow(flux, inflow_.on(b));
        if (equation_->free)
            map_cells(
                inflow_.on(b), [](double in, double free) { return in * free; }, inflow_.on(b), equation_->free->on(b));
    });
}

tasks::Job ScalarDiffusion::choose_share(tasks::Lane& lane)
{
    for_blocks(lane, [&](core::LocalBlock b) {
        transmissibility_sum(geometry(b), equation_->diffusivity.on(b), diagonal_.on(b));
        if (equation_->free)
            map_cells(
                diagonal_.on(b), [](double sum, double free) { return sum * free; }, diagonal_.on(b), equation_->free->on(b));
    });
    double rate = 0;
    co_await find_largest_rate(lane, context_.mesh, diagonal_, equation_->capacity, rate);
    number_ = equation_->dt * rate;
    implicit_ = number_ > 2 ? 1 - 1 / number_ : 0.5; // old values then keep a weight that is not negative
}

tasks::Job ScalarDiffusion::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            change_.on(b), [](double x) { return x; }, part(b, in));
    });
    co_await form_inflow(lane, change_);
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            layout_.view(b, out),
            [d = implicit_ * equation_->dt](double w, double v, double x, double inflow) { return w * v * x - d * inflow; },
            equation_->capacity.on(b), geometry(b).volume.view(), part(b, in), inflow_.on(b));
    });
}

tasks::Job ScalarDiffusion::prepare_multigrid(tasks::Lane& lane)
{
    by_multigrid_ = multigrid_.pays(number_);
    if (!by_multigrid_) co_return;
    multigrid_.prepare();
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto [factor, shift] = multigrid_.parts(b);
        const double now = implicit_ * equation_->dt;
        map_faces(
            factor, [now](double d) { return now * d; }, equation_->diffusivity.on(b));
        map_cells(
            shift, [](double w, double v) { return w * v; }, equation_->capacity.on(b), geometry(b).volume.view());
    });
    co_await multigrid_.set_up(lane);
    co_await multigrid_.expect_right(lane, residual_);
}

tasks::Job ScalarDiffusion::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    if (by_multigrid_) {
        co_await multigrid_.precondition(lane, in, out);
        co_return;
    }
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            layout_.view(b, out),
            [d = implicit_ * equation_->dt](double w, double v, double r, double sum) { return r / (w * v + d * sum); },
            equation_->capacity.on(b), geometry(b).volume.view(), part(b, in), diagonal_.on(b));
    });
    co_return;
}

/// The right-hand side, and the residual of the old values.
tasks::Job ScalarDiffusion::form_right(tasks::Lane& lane, core::ScalarField& q)
{
    co_await form_inflow(lane, q);
    const double old = (1 - implicit_) * equation_->dt, now = implicit_ * equation_->dt;
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto volume = geometry(b).volume.view();
        map_cells(
            right_.on(b), [old](double v, double s, double inflow) { return v * s + old * inflow; }, volume, equation_->source.on(b),
            inflow_.on(b));
        map_cells(
            layout_.view(b, residual_),
            [now](double right, double w, double v, double x, double inflow) { return right - w * v * x + now * inflow; }, right_.on(b),
            equation_->capacity.on(b), volume, q.on(b), inflow_.on(b));
    });
}

tasks::Job ScalarDiffusion::solve(tasks::Lane& lane, DiffusionEquation equation, core::ScalarField& q)
{
    equation_ = &equation;
    products_ = 0;
    co_await choose_share(lane);
    co_await form_right(lane, q);
    std::vector<double> sums(std::size_t(context_.mesh.blocks()), 0.0);
    for_blocks(lane, [&](core::LocalBlock b) {
        sums[std::size_t(context_.mesh.global(b))] = sum_cells([](double w, double v, double x) { return w * v * x * w * v * x; },
                                                               equation.capacity.on(b), geometry(b).volume.view(), q.on(b));
    });
    co_await lane.sum(sums);
    KrylovOptions options;
    options.relative = 1e-14; // where there is nothing yet
    for (const double s : sums) options.absolute += s;
    options.absolute = equation.tolerance * std::sqrt(options.absolute);
    options.from_zero = true;
    options.unknown = "scalar";
    std::fill(solution_.begin(), solution_.end(), 0.0);
    KrylovReport report;
    co_await prepare_multigrid(lane);
    co_await drive(lane, bicgstab(lane.team(), workspace_, options, residual_, solution_, report), *this);
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            q.on(b), [](double x, double d) { return x + d; }, q.on(b), part(b, solution_));
    });
    co_await form_inflow(lane, q); // fluxes of the solution: what goes from cell to cell is neither made nor lost
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            q.on(b),
            [now = implicit_ * equation.dt](double right, double inflow, double w, double v) { return (right + now * inflow) / (w * v); },
            right_.on(b), inflow_.on(b), equation.capacity.on(b), geometry(b).volume.view());
    });
}

} // namespace physics
