// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/turbulence_step.hpp"
#include "core/base/error.hpp"
#include "core/grid/face_distance.hpp"
#include "physics/coupling/turbulence_damping.hpp"
#include "physics/fluid/cell_loops.hpp"

#include <algorithm>

namespace physics {

using core::FaceView, core::LocalBlock, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;
using Vectors = core::VectorView<const double>;

namespace {

core::FieldInfo scratch(const char* name, const char* unit, int halo = 0) { return {name, unit, halo, false}; }

void fill(core::ScalarField& field, int blocks, double value)
{
    field.allocate();
    for (LocalBlock b = 0; b < blocks; ++b) std::fill(field.data(b, 0).begin(), field.data(b, 0).end(), value);
}

/// Of the cells of all blocks of this rank from walls that hold the fluid [m].
std::vector<core::Array3<double>> wall_distances(const core::Mesh& mesh, const BoundaryConditions& conditions)
{
    std::vector<std::string> names;
    for (const core::Boundary& boundary : mesh.topology().boundaries) {
        const auto said = conditions.find(boundary.name);
        if (said == conditions.end() || said->second.kind == BoundaryKind::wall) names.push_back(boundary.name);
    }
    const core::FaceDistance faces(mesh, names);
    std::vector<core::Array3<double>> distances;
    for (LocalBlock b = 0; b < mesh.own_count(); ++b) distances.push_back(faces.of_cells(mesh.geometry(b)));
    return distances;
}

std::vector<EntryValues> entering(const core::Mesh& mesh, const TurbulenceParameters& parameters, double Turbulence::*part)
{
    std::map<std::string, double> values;
    for (const auto& [name, turbulence] : parameters.entering) values[name] = turbulence.*part;
    return entry_values(mesh, values);
}

} // namespace

TurbulenceStep::TurbulenceStep(const core::Mesh& mesh, FluidStep& fluid, const TurbulenceParameters& parameters, CoupledStep* coupling)
    : mesh_(mesh),
      fluid_(fluid),
      parameters_(parameters),
      acts_on_grains_(coupling),
      entering_k_(entering(mesh, parameters, &Turbulence::k)),
      entering_epsilon_(entering(mesh, parameters, &Turbulence::epsilon)),
      k_({"k", "m2/s2", 1, true}, mesh.own_cells()),
      epsilon_({"epsilon", "m2/s3", 1, true}, mesh.own_cells()),
      strain_({"strain of turbulence", "1/s2", 0, true}, mesh.own_cells()),
      forcing_({"forcing of turbulence", "1/s2", 0, true}, mesh.own_cells()),
      eddy_(scratch("eddy viscosity", "m2/s", 1), mesh.own_cells()),
      share_(scratch("share of the carrier of turbulence", "1", 1), mesh.own_cells()),
      k_capacity_(scratch("capacity for k", "1"), mesh.own_cells()),
      k_source_(scratch("source of k", "m2/s2"), mesh.own_cells()),
      epsilon_capacity_(scratch("capacity for epsilon", "1"), mesh.own_cells()),
      epsilon_source_(scratch("source of epsilon", "m2/s3"), mesh.own_cells()),
      free_(scratch("cells away from walls", "1"), mesh.own_cells()),
      flux_(mesh, fluid, coupling, "turbulence"),
      face_share_(scratch("share of the carrier of turbulence on faces", "1"), mesh.own_cells()),
      diffusivity_(scratch("diffusivity of turbulence", "m2/s"), mesh.own_cells()),
      clock_("fluid clock", fluid.state().clock),
      halos_(fluid.system_context().halos),
      carrier_(fluid.system_context()),
      diffusion_(fluid.system_context(), fluid.pressure_system())
{
    core::require<core::ConfigError>(fluid.parameters().viscosity > 0,
                                     "turbulence needs a fluid with viscosity: the layers at walls follow from it");
    const auto& boundaries = mesh.topology().boundaries;
    for (const auto& entry : parameters.entering)
        core::require<core::ConfigError>(
            std::any_of(boundaries.begin(), boundaries.end(), [&](const auto& b) { return b.name == entry.first; }),
            core::text("turbulence: no boundary is called '", entry.first, "'"));
    for (LocalBlock b = 0; b < mesh.own_count(); ++b) wall_cells_.push_back(wall_cells(mesh.geometry(b), sides(b)));
    if (parameters.walls == WallTreatment::resolved) wall_distance_ = wall_distances(mesh, fluid.parameters().boundaries);
    fill(k_, mesh.own_count(), std::max(parameters.initial.k, least_turbulence.k));
    fill(epsilon_, mesh.own_count(), std::max(parameters.initial.epsilon, least_turbulence.epsilon));
    fill(strain_, mesh.own_count(), 0.0);
    fill(forcing_, mesh.own_count(), 0.0);
    for (core::ScalarField* field : {&k_capacity_, &k_source_, &epsilon_capacity_, &epsilon_source_, &free_}) field->allocate();
    diffusivity_.allocate();
    if (coupling) {
        coupling->resist_turbulence();
        face_share_.allocate();
        halos_.prepare(&share_, core::beside);
        act_on_grains();
    }
    fluid.fields().viscosity_ratio.begin();
}

void TurbulenceStep::act_on_grains()
{
    acts_on_grains_ = true;
    halos_.prepare(&eddy_, core::beside);
}

std::variant<ModelledWalls, ResolvedWalls> TurbulenceStep::walls(LocalBlock b) const
{
    const double viscosity = fluid_.parameters().viscosity;
    const auto& cells = wall_cells_[std::size_t(b)];
    if (wall_distance_.empty()) return ModelledWalls{viscosity, parameters_.roughness, cells};
    return ResolvedWalls{viscosity, cells, wall_distance_[std::size_t(b)].view()};
}

core::Array3<double> TurbulenceStep::eddy_viscosity(LocalBlock b) const
{
    core::Array3<double> eddy(mesh_.geometry(b).cells);
    std::visit([&](const auto& w) { find_eddy_viscosity(w, k_.on(b), epsilon_.on(b), strain_.on(b), eddy.view()); }, walls(b));
    return eddy;
}

void TurbulenceStep::set_viscosity_on_faces(LocalBlock b, View<const double> eddy, View<const double> k, FaceView<double> ratio) const
{
    viscosity_on_faces(mesh_.geometry(b), sides(b), fluid_.parameters().viscosity, eddy, ratio);
    std::visit([&](const auto& w) { set_wall_viscosity(w, k, ratio); }, walls(b));
}

void TurbulenceStep::declare_viscosity(tasks::StageGraph& graph)
{
    graph.each_block(
        "eddy viscosity",
        [this](LocalBlock b, View<const double> k, View<const double> epsilon, View<const double> strain, View<double> out) {
            std::visit([&](const auto& w) { find_eddy_viscosity(w, k, epsilon, strain, out); }, walls(b));
        },
        reads(k_, epsilon_, strain_), writes(eddy_));
    graph.each_block(
        "viscosity on faces",
        [this](LocalBlock b, View<const double> eddy, View<const double> k, FaceView<double> ratio) {
            set_viscosity_on_faces(b, eddy, k, ratio);
        },
        reads(beside(eddy_), k_), writes(fluid_.fields().viscosity_ratio));
}

void TurbulenceStep::declare_before(tasks::StageGraph& graph)
{
    graph.boundary(eddy_, "walls of eddy viscosity", [this](LocalBlock b, View<double> nu) { mirror_even(sides(b), 1, nu); });
    if (!acts_on_grains_) declare_viscosity(graph);
    flux_.declare_old_half(graph);
    flux_.declare_shares(graph, share_);
}

void TurbulenceStep::declare(tasks::StageGraph& graph)
{
    auto& f = fluid_.fields();
    flux_.declare_new_half(graph, FluidFlux::Grains::as_before);
    graph.each_block(
        "strain", [](LocalBlock, const core::TensorView<const double>& g, View<double> out) { physics::strain(g[0], g[1], g[2], out); },
        reads(f.velocity_gradient), writes(strain_));
    graph.whole(
        "carry turbulence",
        [this](tasks::Lane& lane, const core::FaceField& flux, const core::VectorField& velocity, const ViscosityRatio&,
               const FluidClock& clock, core::ScalarField&, core::ScalarField&, core::ScalarField&, core::ScalarField&,
               core::ScalarField&) { return advance(lane, flux, clock.dt, velocity); },
        reads(flux_.mean(), fluid_.state().velocity, f.viscosity_ratio, clock_), updates(k_, epsilon_, strain_, forcing_, share_));
    if (flux_.coupling()) declare_damping(graph, flux_.coupling()->fields().resistance);
    for (core::ScalarField* field : {&k_, &epsilon_, &strain_, &forcing_}) graph.sink(*field);
    if (acts_on_grains_) declare_viscosity(graph);
}

/// By the grains as they were at the start of the step: nothing waits for what they do.
void TurbulenceStep::declare_damping(tasks::StageGraph& graph, core::FieldBatch<resisting>& grains)
{
    graph.each_block(
        "damp turbulence between grains",
        [rho = fluid_.parameters().density](LocalBlock, std::array<View<const double>, resisting> grains, View<const double> share,
                                            const FluidClock& clock, View<double> k, View<double> epsilon) {
            core::for_each_cell(k.extents(), [&](int i, int j, int m) {
                const Turbulence at{k(i, j, m), epsilon(i, j, m)};
                const GrainResistance around{grains[resisting_drag](i, j, m), grains[resisting_mass](i, j, m)};
                const Turbulence left = damped(at, turbulence_damping(around, rho * share(i, j, m), at), clock.dt);
                k(i, j, m) = left.k;
                epsilon(i, j, m) = left.epsilon;
            });
        },
        reads(grains, share_, clock_), updates(k_, epsilon_));
}

tasks::Job TurbulenceStep::find_viscosity(tasks::Lane& lane)
{
    eddy_.allocate();
    for_blocks(lane, [&](LocalBlock b) {
        std::visit([&](const auto& w) { find_eddy_viscosity(w, k_.on(b), epsilon_.on(b), strain_.on(b), eddy_.on(b)); }, walls(b));
    });
    co_await halos_.fill(lane, &eddy_, core::beside);
    for_blocks(lane, [&](LocalBlock b) {
        mirror_even(sides(b), 1, eddy_.on(b));
        set_viscosity_on_faces(b, eddy_.on(b), k_.on(b), fluid_.fields().viscosity_ratio.on(b));
    });
}

tasks::Job TurbulenceStep::find_face_shares(tasks::Lane& lane)
{
    co_await halos_.fill(lane, &share_, core::beside);
    for_blocks(lane, [&](LocalBlock b) {
        mirror_even(sides(b), 1, share_.on(b));
        mean_on_faces(mesh_.geometry(b), share_.on(b), face_share_.on(b));
    });
}

tasks::Job TurbulenceStep::advance(tasks::Lane& lane, const core::FaceField& flux, double dt, const core::VectorField& velocity)
{
    const std::array<CarriedScalar, 2> carried{{{&k_, entering_k_}, {&epsilon_, entering_epsilon_}}};
    if (flux_.coupling()) co_await find_face_shares(lane);
    co_await carrier_.carry(lane, {flux, share_, dt}, carried);
    for_blocks(lane, [&](LocalBlock b) {
        std::visit([&](const auto& w) { form_sources(sides(b), w, velocity.on(b), dt, cells(b), equations(b)); }, walls(b));
    });
    co_await solve(lane, dt);
    if (wall_distance_.empty()) for_blocks(lane, [&](LocalBlock b) { find_forcing(equations(b), cells(b), dt, forcing_.on(b)); });
    for_blocks(lane, [&](LocalBlock b) { // skewed cells may take too much; round-off is no turbulence
        map_cells(
            k_.on(b), [](double q) { return q < 2 * least_turbulence.k ? least_turbulence.k : q; }, k_.on(b));
        map_cells(
            epsilon_.on(b), [](double q) { return std::max(q, least_turbulence.epsilon); }, epsilon_.on(b));
    });
}

TurbulenceCells TurbulenceStep::cells(LocalBlock b)
{
    return {k_.on(b), epsilon_.on(b), std::as_const(forcing_).on(b), strain_.on(b), share_.on(b)};
}

TurbulenceEquations TurbulenceStep::equations(LocalBlock b)
{
    return {k_capacity_.on(b), k_source_.on(b), epsilon_capacity_.on(b), epsilon_source_.on(b), free_.on(b)};
}

void TurbulenceStep::set_diffusivity(tasks::Lane& lane, double sigma)
{
    for_blocks(lane, [&](LocalBlock b) {
        const auto spread = [nu = fluid_.parameters().viscosity, sigma](double ratio) { return nu * (1 + (ratio - 1) / sigma); };
        map_faces(diffusivity_.on(b), spread, *std::as_const(fluid_.fields()).viscosity_ratio.on(b));
        if (flux_.coupling())
            map_faces(
                diffusivity_.on(b), [](double d, double phi) { return d * phi; }, diffusivity_.on(b), face_share_.on(b));
    });
}

tasks::Job TurbulenceStep::solve(tasks::Lane& lane, double dt)
{
    constexpr double tolerance = 1e-8; // no amount is to be kept here; epsilon is a thousand times larger at walls than far from them
    const bool modelled = wall_distance_.empty();
    set_diffusivity(lane, modelled ? k_epsilon.sigma_k : k_epsilon_resolved.sigma_k);
    co_await diffusion_.solve(lane, {diffusivity_, k_capacity_, k_source_, dt, tolerance}, k_);
    set_diffusivity(lane, modelled ? k_epsilon.sigma_epsilon : k_epsilon_resolved.sigma_epsilon);
    co_await diffusion_.solve(lane, {diffusivity_, epsilon_capacity_, epsilon_source_, dt, tolerance, &free_}, epsilon_);
}

} // namespace physics
