// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/scalar_step.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/cell_loops.hpp"

#include <algorithm>

namespace physics {

using core::FaceView, core::LocalBlock;
using tasks::reads, tasks::updates, tasks::writes;

ScalarStep::ScalarStep(const core::Mesh& mesh, FluidStep& fluid, const std::vector<ScalarParameters>& scalars)
    : mesh_(mesh), fluid_(fluid), parameters_(scalars), fields_(mesh, scalars), part_("scalars", fields_), clock_("fluid clock", fluid.state().clock),
      carrier_(fluid.system_context()), flux_({"flux that carries scalars", "m3/s", 0, false}, mesh.own_cells()),
      diffusivity_({"diffusivity of a scalar", "m2/s", 0, false}, mesh.own_cells()),
      source_({"amount of a scalar", "", 0, false}, mesh.own_cells())
{
    const auto& boundaries = mesh.topology().boundaries;
    for (const ScalarParameters& scalar : parameters_) {
        for (const auto& [name, value] : scalar.entering)
            core::require<core::ConfigError>(std::any_of(boundaries.begin(), boundaries.end(), [&](const auto& b) { return b.name == name; }),
                                             core::text("scalar '", scalar.name, "': no boundary is called '", name, "'"));
        entering_.push_back(entry_values(mesh, scalar.entering));
    }
    if (std::none_of(parameters_.begin(), parameters_.end(), [](const auto& s) { return s.diffusivity > 0; })) return;
    diffusion_ = std::make_unique<ScalarDiffusion>(fluid.system_context(), fluid.pressure_system().layout());
    diffusivity_.allocate();
    source_.allocate();
}

void ScalarStep::declare_before(tasks::StageGraph& graph)
{
    graph.each_block(
        "flux that carries scalars, old half",
        [](LocalBlock, FaceView<const double> flux, FaceView<double> mean) { map_faces(mean, [](double f) { return 0.5 * f; }, flux); },
        reads(fluid_.state().flux), writes(flux_));
}

void ScalarStep::declare(tasks::StageGraph& graph)
{
    graph.each_block(
        "flux that carries scalars, new half",
        [](LocalBlock, FaceView<const double> flux, FaceView<double> mean) { map_faces(mean, [](double m, double f) { return m + 0.5 * f; }, mean, flux); },
        reads(fluid_.state().flux), updates(flux_));
    graph.whole(
        "carry scalars",
        [this](tasks::Lane& lane, const core::FaceField& flux, const FluidClock& clock, ScalarSet& fields) -> tasks::Job {
            std::vector<CarriedScalar> carried;
            for (std::size_t n = 0; n < fields.values.size(); ++n) carried.push_back({&fields.values[n], entering_[n]});
            co_await carrier_.carry(lane, {flux, fields.share, clock.dt}, carried);
            if (diffusion_) co_await diffuse(lane, clock.dt, fields);
        },
        reads(flux_, clock_), updates(part_));
    graph.sink(part_);
}

tasks::Job ScalarStep::diffuse(tasks::Lane& lane, double dt, ScalarSet& fields)
{
    for (std::size_t n = 0; n < fields.values.size(); ++n) {
        const double diffusivity = parameters_[n].diffusivity;
        if (diffusivity == 0) continue;
        lane.team().run(mesh_.own_count(), [&](int b) {
            map_faces(diffusivity_.on(b), [diffusivity](double) { return diffusivity; }, diffusivity_.on(b));
            map_cells(source_.on(b), [](double w, double q) { return w * q; }, fields.share.on(b), fields.values[n].on(b));
        });
        co_await diffusion_->solve(lane, {diffusivity_, fields.share, source_, dt}, fields.values[n]);
    }
}

} // namespace physics
