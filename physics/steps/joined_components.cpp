// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/joined_components.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/wall_profile.hpp"
#include "physics/steps/krylov_job.hpp"

#include <cmath>
#include <utility>

namespace physics {
namespace {

BlockLayout tripled(const BlockLayout& single)
{
    std::vector<core::Extents> cells;
    for (core::LocalBlock b = 0; b < single.blocks(); ++b) {
        cells.push_back(single.cells(b));
        cells.back().nk *= 3;
    }
    return {{single.ids().begin(), single.ids().end()}, std::move(cells), 0};
}

} // namespace

JoinedComponents::JoinedComponents(const SystemContext& context, const BlockLayout& layout)
    : context_(context),
      single_(layout),
      layout_(tripled(layout)),
      workspace_(layout_, context.mesh.blocks(), 3 * std::ptrdiff_t(context.mesh.total_cells())),
      value_({"change of velocity", "m/s", 1, false}, context.mesh.own_cells()),
      gradient_({"gradient of the change of velocity", "1/s", 1, false}, context.mesh.own_cells()),
      flux_({"flux of the change of velocity", "m3/s", 0, false}, context.mesh.own_cells()),
      right_(layout_.size(), 0.0),
      solution_(layout_.size(), 0.0),
      single_in_(single_.size(), 0.0),
      single_out_(single_.size(), 0.0)
{
    value_.allocate();
    flux_.allocate();
    context_.halos.prepare(&value_, core::beside);
    if (context_.is_straight) return; // nothing reads the gradient
    gradient_.allocate();
    context_.halos.prepare(&gradient_, core::beside);
}

template <class T>
core::View<T> JoinedComponents::component(core::LocalBlock b, int c, std::span<T> all) const
{
    return {all.data() + layout_.origin(b) + c * std::ptrdiff_t(single_.cells(b).size()), single_.cells(b), 0};
}

tasks::Job JoinedComponents::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    constexpr auto same = [](double x) { return x; };
    for_blocks(lane, [&](core::LocalBlock b) {
        for (int c = 0; c < 3; ++c) map_cells(value_.on(b).component(c), same, component(b, c, in));
    });
    co_await context_.halos.fill(lane, &value_, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto& walls = context_.walls[std::size_t(b)];
        mirror_velocity_change(walls, value_.on(b));
        for (int c = 0; c < 3 && !context_.is_straight; ++c)
            velocity_gradient(geometry, walls, context_.viscosity_factors(b), value_.on(b).component(c), gradient_.on(b)[std::size_t(c)]);
    });
    if (!context_.is_straight) co_await context_.halos.fill(lane, &gradient_, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const core::TensorView<const double> g = context_.is_straight ? core::TensorView<const double>{} : std::as_const(gradient_).on(b);
        for (int c = 0; c < 3; ++c) {
            const auto result = component(b, c, out);
            diffusive_inflow(geometry, context_.walls[std::size_t(b)], value_.on(b).component(c), g[std::size_t(c)],
                             context_.viscosity_factors(b), {flux_.on(b), result});
            map_cells(
                result, [d = equation_->diffusion](double inflow, double volume, double x) { return volume * x - d * inflow; }, result,
                geometry.volume.view(), component(b, c, in));
        }
    });
}

tasks::Job JoinedComponents::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    constexpr auto same = [](double x) { return x; };
    for (int c = 0; c < 3; ++c) {
        for_blocks(lane, [&](core::LocalBlock b) { map_cells(single_.view(b, single_in_), same, component(b, c, in)); });
        co_await equation_->precondition(lane, single_in_, single_out_);
        for_blocks(lane, [&](core::LocalBlock b) { map_cells(component(b, c, out), same, single_.view(b, single_out_)); });
    }
}

tasks::Job JoinedComponents::solve(tasks::Lane& lane, const Equation& equation, const KrylovOptions& options,
                                   const core::VectorField& residual, std::array<core::VectorField*, 2> gaining, int& iterations)
{
    equation_ = &equation;
    std::fill(solution_.begin(), solution_.end(), 0.0);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto r = residual.on(b);
        for (int c = 0; c < 3; ++c)
            map_cells(
                component(b, c, std::span(right_)), [](double x) { return x; }, r.component(c));
        map_cells(
            single_.view(b, single_in_), [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }, r.x, r.y, r.z);
    });
    co_await equation.expect_right(lane, single_in_);
    KrylovReport report;
    co_await drive(lane, bicgstab(lane.team(), workspace_, options, right_, solution_, report), *this);
    iterations += 2 * report.iterations;
    for_blocks(lane, [&](core::LocalBlock b) {
        for (core::VectorField* field : gaining)
            for (int c = 0; c < 3; ++c) {
                const auto x = field->on(b).component(c);
                map_cells(
                    x, [](double old, double step) { return old + step; }, x, component(b, c, std::span(solution_)));
            }
    });
    equation_ = nullptr;
}

} // namespace physics
