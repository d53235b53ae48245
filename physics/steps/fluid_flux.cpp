// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/fluid_flux.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

FluidFlux::FluidFlux(const core::Mesh& mesh, FluidStep& fluid, CoupledStep* coupling, const std::string& carried)
    : mesh_(mesh),
      fluid_(fluid),
      coupling_(coupling),
      carried_(carried),
      mean_({"flux that carries " + carried, "m3/s", 0, false}, mesh.own_cells()),
      scratch_({"flux of grains beside " + carried, "m3/s", 0, false}, mesh.own_cells()),
      solid_({"flux density of grains beside " + carried, "m/s", 1, false, true}, mesh.own_cells())
{
}

void FluidFlux::declare_solid(tasks::StageGraph& graph)
{
    graph.each_block(
        "flux density of grains beside " + carried_,
        [](LocalBlock, GrainSumViews sums, VectorView<double> out) { flux_density_of_grains(sums, out); }, reads(coupling_->fields().sums),
        writes(solid_));
}

void FluidFlux::find_flux_of_grains(LocalBlock b, Vectors density, FaceView<double> flux) const
{
    flux_of_grains(mesh_.geometry(b), fluid_.walls()[std::size_t(b)], density, flux);
}

void FluidFlux::declare_old_half(tasks::StageGraph& graph)
{
    if (!coupling_) {
        graph.each_block(
            "flux that carries " + carried_ + ", old half",
            [](LocalBlock, FaceView<const double> flux, FaceView<double> mean) {
                map_faces(
                    mean, [](double f) { return 0.5 * f; }, flux);
            },
            reads(fluid_.state().flux), writes(mean_));
        return;
    }
    graph.boundary(solid_, "walls of flux density of grains", [this](LocalBlock b, VectorView<double> g) {
        for (int c = 0; c < 3; ++c) mirror_even(fluid_.walls()[std::size_t(b)], 1, g.component(c));
    });
    declare_solid(graph);
    graph.each_block(
        "flux that carries " + carried_ + " beside grains, old half",
        [this](LocalBlock b, FaceView<const double> flux, Vectors solid, FaceView<double> of_grains, FaceView<double> mean) {
            find_flux_of_grains(b, solid, of_grains);
            map_faces(
                mean, [](double f, double s) { return 0.5 * (f - s); }, flux, of_grains);
        },
        reads(fluid_.state().flux, beside(solid_)), writes(scratch_, mean_));
}

void FluidFlux::declare_new_half(tasks::StageGraph& graph, Grains grains)
{
    if (!coupling_) {
        graph.each_block(
            "flux that carries " + carried_ + ", new half",
            [](LocalBlock, FaceView<const double> flux, FaceView<double> mean) {
                map_faces(
                    mean, [](double m, double f) { return m + 0.5 * f; }, mean, flux);
            },
            reads(fluid_.state().flux), updates(mean_));
        return;
    }
    if (grains == Grains::moved) declare_solid(graph);
    graph.each_block(
        "flux that carries " + carried_ + " beside grains, new half",
        [this](LocalBlock b, FaceView<const double> flux, Vectors solid, FaceView<double> of_grains, FaceView<double> mean) {
            find_flux_of_grains(b, solid, of_grains);
            map_faces(
                mean, [](double m, double f, double s) { return m + 0.5 * (f - s); }, mean, flux, of_grains);
        },
        reads(fluid_.state().flux, beside(solid_)), writes(scratch_), updates(mean_));
}

void FluidFlux::declare_shares(tasks::StageGraph& graph, core::ScalarField& out)
{
    if (coupling_)
        graph.each_block(
            "share of the carrier of " + carried_,
            [](LocalBlock, core::View<const double> phi, core::View<double> share) {
                map_cells(
                    share, [](double x) { return x; }, phi);
            },
            reads(coupling_->fields().fraction), writes(out));
    else
        graph.each_block(
            "share of the carrier of " + carried_,
            [](LocalBlock, core::View<double> share) {
                map_cells(
                    share, [](double) { return 1.0; }, share);
            },
            writes(out));
}

void mean_on_faces(const core::BlockGeometry& geometry, core::View<const double> q, core::FaceView<double> faces)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto out = faces.along(axis);
        const core::Extents n = out.extents();
        const std::ptrdiff_t back = q.stride(axis);
        for (int k = 0; k < n.nk; ++k)
            for (int j = 0; j < n.nj; ++j) {
                const double* v = q.row(j, k);
                double* f = out.row(j, k);
#pragma omp simd
                for (int i = 0; i < n.ni; ++i) f[i] = 0.5 * (v[i] + v[i - back]);
            }
    }
    combine_at_sub_faces(geometry, q, faces, [](double a, double b, double) { return 0.5 * (a + b); });
}

} // namespace physics
