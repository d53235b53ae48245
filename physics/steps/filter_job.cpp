// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/filter_job.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/mesh_links.hpp"
#include "physics/fluid/mobility.hpp"

namespace physics {
namespace {

/// Most cells of the mesh share their volume field with nobody: the filter wants it as a field.
core::ScalarField volumes(const core::Mesh& mesh)
{
    core::ScalarField volume({"volume", "m3", 0, false}, mesh.own_cells());
    volume.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        map_cells(
            volume.on(b), [](double v) { return v; }, mesh.geometry(b).volume.view());
    return volume;
}

core::FaceField spreadings(const core::Mesh& mesh)
{
    core::FaceField faces({"spreading", "m", 0, false}, mesh.own_cells());
    faces.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) spreading(mesh.geometry(b), faces.on(b));
    return faces;
}

} // namespace

tasks::Job set_up(tasks::Lane& lane, Filter& filter, Coefficients transmissibility, const core::ScalarField& volume)
{
    double bound = 0.0;
    lane.attempt([&] {
        filter.load(lane.team(), transmissibility, volume);
        bound = filter.eigenvalue_bound();
    });
    co_await lane.max(std::span(&bound, 1));
    filter.set_bound(bound); // throws on all ranks alike
}

tasks::Job set_up_on_mesh(tasks::Lane& lane, Filter& filter, const core::Mesh& mesh, int rank)
{
    if (filter.degree() > 0) co_return; // it knows the mesh, which never changes: on all ranks alike
    const core::ScalarField volume = volumes(mesh);
    const core::FaceField faces = spreadings(mesh);
    const MeshLinks links = make_mesh_links(mesh, rank);
    co_await set_up(lane, filter, {&faces, links.spreading, nullptr}, volume);
}

tasks::Job run(tasks::Lane& lane, Filter& filter, int fields)
{
    if (!filter.has_ghosts()) {
        lane.attempt([&] { filter.run(lane.team(), fields); });
        co_return;
    }
    for (int number = 1; number <= filter.degree(); ++number) {
        core::Pending pending;
        {
            const auto mpi = lane.messages();
            filter.start_ghosts(number, fields, lane.communicator(), pending);
        }
        co_await lane.arrive(pending);
        lane.attempt([&] { filter.pass(lane.team(), number, fields); });
    }
}

} // namespace physics
