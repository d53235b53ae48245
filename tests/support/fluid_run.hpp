// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A fluid alone, from a grid and its parameters to steps: what every test of the fluid starts from.
#include "core/comm/reduce.hpp"
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/time_step.hpp"
#include "physics/steps/fluid_step.hpp"
#include "physics/steps/scalar_step.hpp"
#include "physics/steps/turbulence_step.hpp"
#include "tasks/exchange_filler.hpp"
#include "tasks/executor.hpp"
#include "tests/support/volume_mean.hpp"
#include <cmath>
#include <functional>
#include <numbers>

namespace test {

using core::Vec3;
using VectorFunction = std::function<Vec3(const Vec3&)>;
using ScalarFunction = std::function<double(const Vec3&)>;

/// What the fluid of a run has beside its momentum.
struct Carried {
    std::vector<physics::ScalarParameters> scalars{};
    std::optional<physics::TurbulenceParameters> turbulence{};
};

class FluidRun {
public:
    explicit FluidRun(core::MultiBlock grid, const physics::FluidParameters& parameters,
                      const tasks::ExecutorOptions& executor = {.kind = "serial"},
                      const core::Communicator& ranks = core::Communicator::world(), const Carried& carried = {})
        : ranks_(ranks),
          mesh_(std::move(grid), ranks_.rank(), ranks_.size()),
          filler_(mesh_, ranks_),
          step_(mesh_, ranks_, filler_, parameters),
          graph_(layout(mesh_), ranks_)
    {
        graph_.fill_halos_with(filler_);
        if (!carried.scalars.empty()) scalars_.emplace(mesh_, step_, carried.scalars);
        if (carried.turbulence) turbulence_.emplace(mesh_, step_, *carried.turbulence);
        if (turbulence_) turbulence_->declare_before(graph_);
        if (scalars_) scalars_->declare_before(graph_);
        step_.declare(graph_);
        if (turbulence_) turbulence_->declare(graph_);
        if (scalars_) scalars_->declare(graph_);
        graph_.sink(step_.state().flux);
        plan_ = std::make_unique<tasks::Plan>(graph_.compile({"budget"}));
        executor_ = tasks::make_executor(executor, *plan_);
    }

    /// Sets the state at time 0; fluxes are interpolated.
    void start(
        const VectorFunction& velocity, const ScalarFunction& pressure = [](const Vec3&) { return 0.0; })
    {
        auto& state = step_.state();
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) {
            const auto u = state.velocity.on(b);
            core::for_each_cell(mesh_.geometry(b).cells, [&](int i, int j, int k) {
                const Vec3 x = mesh_.geometry(b).centre(i, j, k), v = velocity(x);
                u.x(i, j, k) = v.x();
                u.y(i, j, k) = v.y();
                u.z(i, j, k) = v.z();
                state.pressure.on(b)(i, j, k) = pressure(x);
            });
        }
        const core::HaloExchange exchange(mesh_, ranks_, 3, 1, core::HaloShape::faces);
        exchange.fill(state.velocity);
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) {
            physics::mirror_velocity(step_.walls()[std::size_t(b)], 1, state.velocity.on(b));
            physics::interpolated_flux(mesh_.geometry(b), step_.walls()[std::size_t(b)], state.velocity.on(b), state.flux.on(b));
        }
    }

    void step(double dt)
    {
        auto& clock = step_.state().clock;
        clock.dt = dt;
        step_.begin_step();
        executor_->run_step(clock.step);
        clock.advance();
    }

    /// sqrt of the volume mean of |velocity - expected|^2.
    [[nodiscard]] double velocity_error(const VectorFunction& expected) const
    {
        return std::sqrt(mean(
            [&](core::LocalBlock b, int i, int j, int k) { return (velocity(b, i, j, k) - expected(centre(b, i, j, k))).squaredNorm(); }));
    }
    /// The same of the pressure, means removed.
    [[nodiscard]] double pressure_error(const ScalarFunction& expected) const
    {
        const auto difference = [&](core::LocalBlock b, int i, int j, int k) {
            return step_.state().pressure.on(b)(i, j, k) - expected(centre(b, i, j, k));
        };
        const double shift = mean(difference);
        return std::sqrt(mean([&](core::LocalBlock b, int i, int j, int k) { return std::pow(difference(b, i, j, k) - shift, 2); }));
    }
    [[nodiscard]] double largest(const std::function<double(core::LocalBlock, int, int, int)>& value) const
    {
        return core::max_over_blocks(mesh_, ranks_, [&](core::LocalBlock b) {
            double most = 0;
            core::for_each_cell(mesh_.geometry(b).cells, [&](int i, int j, int k) { most = std::max(most, std::abs(value(b, i, j, k))); });
            return most;
        });
    }
    /// Volume mean of a value in each cell.
    [[nodiscard]] double mean(const OfCell& value) const { return volume_mean(mesh_, ranks_, value); }
    [[nodiscard]] Vec3 velocity(core::LocalBlock b, int i, int j, int k) const
    {
        const auto u = step_.state().velocity.on(b);
        return {u.x(i, j, k), u.y(i, j, k), u.z(i, j, k)};
    }
    [[nodiscard]] Vec3 centre(core::LocalBlock b, int i, int j, int k) const { return mesh_.geometry(b).centre(i, j, k); }
    /// Largest net outflow of a cell over the largest flux through a face.
    [[nodiscard]] double divergence()
    {
        double outflow = 0, flux = 0;
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) {
            const core::FaceView<const double> f = step_.state().flux.on(b);
            core::for_each_cell(mesh_.geometry(b).cells, [&](int i, int j, int k) {
                outflow = std::max(
                    outflow, std::abs(f.i(i + 1, j, k) - f.i(i, j, k) + f.j(i, j + 1, k) - f.j(i, j, k) + f.k(i, j, k + 1) - f.k(i, j, k)));
                flux = std::max({flux, std::abs(f.i(i, j, k)), std::abs(f.j(i, j, k)), std::abs(f.k(i, j, k))});
            });
        }
        return outflow / flux;
    }
    /// Largest share of the fluid of a cell that leaves it per time [1/s].
    [[nodiscard]] double outflow_rate() const
    {
        return core::max_over_blocks(
            mesh_, ranks_, [&](core::LocalBlock b) { return physics::largest_outflow_rate(mesh_.geometry(b), step_.state().flux.on(b)); });
    }
    [[nodiscard]] physics::MomentumBudget budget() const
    {
        physics::MomentumBudget sum;
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) sum += step_.budget().on(b);
        return sum;
    }

    [[nodiscard]] const core::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] physics::FluidStep& fluid() { return step_; }
    /// @pre There are scalars.
    [[nodiscard]] physics::ScalarStep& scalars() { return *scalars_; }
    /// @pre There is turbulence.
    [[nodiscard]] physics::TurbulenceStep& turbulence() { return *turbulence_; }
    [[nodiscard]] const physics::FluidStep& fluid() const { return step_; }
    [[nodiscard]] double time() const { return step_.state().clock.time; }

private:
    static tasks::Layout layout(const core::Mesh& mesh)
    {
        tasks::Layout layout;
        for (const core::Extents& n : mesh.own_cells()) layout.cells.push_back(n.size());
        return layout;
    }

    core::Communicator ranks_;
    core::Mesh mesh_;
    tasks::ExchangeFiller filler_;
    physics::FluidStep step_;
    std::optional<physics::ScalarStep> scalars_;
    std::optional<physics::TurbulenceStep> turbulence_;
    tasks::StageGraph graph_;
    std::unique_ptr<tasks::Plan> plan_;
    std::unique_ptr<tasks::Executor> executor_;
};

/// A pipe of `across` cells in a diameter, half of them in the core.
[[nodiscard]] inline core::MultiBlock pipe_across(int across, double diameter, int axial_cells, int blocks_along)
{
    core::Pipe pipe;
    pipe.diameter = diameter;
    pipe.length = diameter;
    pipe.core_cells = across / 2;
    pipe.wing_cells = across / 4;
    pipe.axial_cells = axial_cells;
    pipe.blocks_along = blocks_along;
    return core::make_pipe(pipe);
}

/// Displaces the vertices of a periodic box of side 2 pi, along x and y alone if flat.
[[nodiscard]] inline Vec3 wavy(const Vec3& x, double amplitude, double third)
{
    return x + amplitude * Vec3(std::sin(x.y()) * std::cos(third * x.z()), std::sin(x.x()), third * std::sin(x.x() + x.y()));
}

} // namespace test
