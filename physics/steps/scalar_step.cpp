// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/scalar_step.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/flux_agreement.hpp"

#include <algorithm>

namespace physics {

using core::LocalBlock;
using tasks::reads, tasks::updates;

struct ScalarStep::Agreement {
    Agreement(const core::Mesh& mesh, const FluidStep& fluid, const core::Communicator& ranks)
        : flux(mesh, fluid, ranks),
          halos(fluid.system_context().halos),
          share({"share of the carrier", "1", 1, false}, mesh.own_cells()),
          faces({"share of the carrier on faces", "1", 0, false}, mesh.own_cells())
    {
        share.allocate();
        faces.allocate();
        halos.prepare(&share, core::beside);
    }
    FluxAgreement flux;
    tasks::HaloFiller& halos;
    core::ScalarField share;
    core::FaceField faces; ///< mean share of the cells of each face
};

ScalarStep::~ScalarStep() = default;

ScalarStep::ScalarStep(const core::Mesh& mesh, FluidStep& fluid, const std::vector<ScalarParameters>& scalars, CoupledStep* coupling,
                       const core::Communicator& ranks)
    : mesh_(mesh),
      fluid_(fluid),
      parameters_(scalars),
      fields_(mesh, scalars),
      part_("scalars", fields_),
      clock_("fluid clock", fluid.state().clock),
      carrier_(fluid.system_context()),
      flux_(mesh, fluid, coupling, "scalars"),
      diffusivity_({"diffusivity of a scalar", "m2/s", 0, false}, mesh.own_cells()),
      source_({"amount of a scalar", "", 0, false}, mesh.own_cells())
{
    const auto& boundaries = mesh.topology().boundaries;
    for (const ScalarParameters& scalar : parameters_) {
        for (const auto& [name, value] : scalar.entering)
            core::require<core::ConfigError>(
                std::any_of(boundaries.begin(), boundaries.end(), [&](const auto& b) { return b.name == name; }),
                core::text("scalar '", scalar.name, "': no boundary is called '", name, "'"));
        entering_.push_back(entry_values(mesh, scalar.entering));
    }
    if (coupling) agreement_ = std::make_unique<Agreement>(mesh, fluid, ranks);
    if (std::none_of(parameters_.begin(), parameters_.end(), [](const auto& s) { return s.diffusivity > 0; })) return;
    diffusion_ = std::make_unique<ScalarDiffusion>(fluid.system_context(), fluid.pressure_system());
    diffusivity_.allocate();
    source_.allocate();
}

void ScalarStep::begin(const core::ScalarField& fraction)
{
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b)
        map_cells(
            fields_.share.on(b), [](double phi) { return phi; }, fraction.on(b));
}

void ScalarStep::declare_before(tasks::StageGraph& graph) { flux_.declare_old_half(graph); }

void ScalarStep::declare(tasks::StageGraph& graph)
{
    flux_.declare_new_half(graph, FluidFlux::Grains::moved);
    if (agreement_)
        graph.whole(
            "carry scalars between grains",
            [this](tasks::Lane& lane, const core::ScalarField&, const FluidClock& clock, core::FaceField& flux,
                   ScalarSet& fields) -> tasks::Job {
                co_await agree_with_grains(lane, flux, clock.dt, fields);
                co_await carry(lane, flux, clock.dt, fields);
            },
            reads(flux_.coupling()->fields().fraction, clock_), updates(flux_.mean(), part_));
    else
        graph.whole(
            "carry scalars",
            [this](tasks::Lane& lane, const FluidClock& clock, core::FaceField& flux, ScalarSet& fields) {
                return carry(lane, flux, clock.dt, fields);
            },
            reads(clock_), updates(flux_.mean(), part_));
    graph.sink(part_);
}

tasks::Job ScalarStep::carry(tasks::Lane& lane, core::FaceField& flux, double dt, ScalarSet& fields)
{
    std::vector<CarriedScalar> carried;
    for (std::size_t n = 0; n < fields.values.size(); ++n) carried.push_back({&fields.values[n], entering_[n]});
    co_await carrier_.carry(lane, {flux, fields.share, dt}, carried);
    if (diffusion_) co_await diffuse(lane, dt, fields);
}

tasks::Job ScalarStep::agree_with_grains(tasks::Lane& lane, core::FaceField& flux, double dt, ScalarSet& fields)
{
    Agreement& a = *agreement_;
    const core::ScalarField& fraction = flux_.coupling()->fields().fraction;
    co_await a.flux.solve(lane, {flux, fields.share, fraction, dt});
    lane.team().run(mesh_.own_count(), [&](int b) {
        map_cells(
            a.share.on(b), [](double phi) { return phi; }, fraction.on(b));
    });
    co_await a.halos.fill(lane, &a.share, core::beside);
    lane.team().run(mesh_.own_count(), [&](int b) {
        a.flux.add(b, flux.on(b));
        mirror_even(fluid_.walls()[std::size_t(b)], 1, a.share.on(b));
        mean_on_faces(mesh_.geometry(b), a.share.on(b), a.faces.on(b));
    });
}

tasks::Job ScalarStep::diffuse(tasks::Lane& lane, double dt, ScalarSet& fields)
{
    for (std::size_t n = 0; n < fields.values.size(); ++n) {
        const double diffusivity = parameters_[n].diffusivity;
        if (diffusivity == 0) continue;
        lane.team().run(mesh_.own_count(), [&](int b) {
            const auto faces = diffusivity_.on(b);
            map_faces(
                faces, [diffusivity](double) { return diffusivity; }, faces);
            if (agreement_)
                map_faces(
                    faces, [](double d, double phi) { return d * phi; }, faces, agreement_->faces.on(b));
            map_cells(
                source_.on(b), [](double w, double q) { return w * q; }, fields.share.on(b), fields.values[n].on(b));
        });
        co_await diffusion_->solve(lane, {diffusivity_, fields.share, source_, dt}, fields.values[n]);
    }
}

} // namespace physics
