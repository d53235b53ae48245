// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pressure equation of a round pipe on a butterfly grid, with a void fraction that varies.
#include "core/grid/pipe.hpp"
#include "physics/fluid/mesh_links.hpp"
#include "tests/support/conduction_boxes.hpp"

namespace test {

/// Twenty blocks; `size` 1 has some 21,000 cells, each doubling eight times as many.
inline ConductionProblem pipe_problem(int size, double wall_growth = 1.0)
{
    core::Pipe pipe;
    pipe.core_cells = 16 * size;
    pipe.wing_cells = 8 * size;
    pipe.axial_cells = 28 * size;
    pipe.wall_growth = wall_growth;
    const core::Mesh mesh(core::make_pipe(pipe), 0, 1);
    const auto links = physics::make_mesh_links(mesh, 0);
    ConductionProblem p(mesh.own_cells());
    p.topology = links.topology;
    const auto fraction = [&](int block, core::Index3 c) {
        const core::Vec3 x = mesh.geometry(block).centre(c.i, c.j, c.k) / pipe.diameter;
        return bed_and_spheres(x.x(), x.y() + 0.5, x.z() + 0.5);
    };
    const auto between = [](double t, double a, double b) { return t * 2.0 * a * b / (a + b); };
    for (int b = 0; b < mesh.blocks(); ++b)
        for (int axis = 0; axis < 3; ++axis)
            core::for_each_cell(mesh.cells(b), [&](int i, int j, int k) {
                const core::Index3 here{i, j, k};
                core::Index3 below = here;
                if (--below[axis] < 0) return;
                p.face.on(b).along(axis)[here] =
                    between(mesh.geometry(b).face[std::size_t(axis)].transmissibility(i, j, k), fraction(b, below), fraction(b, here));
            });
    const auto at_end = [&](const physics::LinkEnd& e) { return fraction(e.block, physics::cell_place(mesh.cells(e.block), e.cell)); };
    for (std::size_t l = 0; l < links.transmissibility.size(); ++l)
        p.link.push_back(between(links.transmissibility[l], at_end(p.topology.links[l].a), at_end(p.topology.links[l].b)));
    return p;
}

} // namespace test
