// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/viscosity_system.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/diffusion.hpp"
#include "physics/steps/krylov_job.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace physics {

ViscositySystem::ViscositySystem(const SystemContext& context, const BlockLayout& layout, const FluidTolerances& tolerances)
    : context_(context), tolerances_(tolerances), layout_(layout),
      workspace_(layout, context.mesh.blocks(), std::ptrdiff_t(context.mesh.total_cells())), unknown_(context, layout, "velocity change"),
      transmissibility_sum_({"transmissibility sum", "m", 0, false}, context.mesh.own_cells()), right_(layout.size(), 0.0),
      solution_(layout.size(), 0.0), norms_(std::size_t(context.mesh.blocks()))
{
    transmissibility_sum_.allocate();
    for (core::LocalBlock b = 0; b < context.mesh.own_count(); ++b)
        transmissibility_sum(context.mesh.geometry(b), transmissibility_sum_.on(b));
}

tasks::Job ViscositySystem::apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    co_await unknown_.form_fluxes(lane, BehindWalls::value, in);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        const auto result = layout_.view(b, out);
        net_outflow(unknown_.flux.on(b), result);
        map_cells(result, [d = diffusion_](double inflow, double volume, double x) { return volume * x - d * inflow; }, result,
                  context_.mesh.geometry(b).volume.view(), core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0));
    });
}

tasks::Job ViscositySystem::precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out)
{
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(layout_.view(b, out), [d = diffusion_](double r, double volume, double sum) { return r / (volume + d * sum); },
                  core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0),
                  context_.mesh.geometry(b).volume.view(), transmissibility_sum_.on(b));
    });
    co_return;
}

tasks::Job ViscositySystem::solve(tasks::Lane& lane, double diffusion, const core::VectorField& inflow, core::VectorField& velocity)
{
    diffusion_ = diffusion;
    iterations_ = 0;
    // Momentum of all components and its viscous change: a change that round-off of the momentum hides is not solved for.
    std::fill(norms_.begin(), norms_.end(), 0.0);
    unknown_.for_blocks(lane, [&](core::LocalBlock b) {
        for (int c = 0; c < 3; ++c)
            norms_[std::size_t(context_.mesh.global(b))] += sum_cells([](double v, double u) { return v * v * u * u; },
                                                                      context_.mesh.geometry(b).volume.view(), velocity.on(b).component(c));
    });
    co_await lane.sum(norms_);
    const double momentum = std::sqrt(std::accumulate(norms_.begin(), norms_.end(), 0.0));
    KrylovOptions options;
    options.relative = tolerances_.viscosity;
    options.absolute = 1e-14 * momentum;
    options.most_iterations = tolerances_.most_iterations;
    options.unknown = "velocity";
    for (int c = 0; c < 3; ++c) {
        std::fill(solution_.begin(), solution_.end(), 0.0);
        unknown_.for_blocks(lane, [&](core::LocalBlock b) {
            map_cells(layout_.view(b, right_), [d = diffusion](double in) { return d * in; }, inflow.on(b).component(c));
        });
        KrylovReport report;
        co_await drive(lane, bicgstab(lane.team(), workspace_, options, right_, solution_, report), *this);
        iterations_ += report.iterations;
        unknown_.for_blocks(lane, [&](core::LocalBlock b) {
            const auto u = velocity.on(b).component(c);
            map_cells(u, [](double old, double change) { return old + change; }, u, layout_.view(b, solution_));
        });
    }
}

} // namespace physics
