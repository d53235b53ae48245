// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Advection along and across the pipe, through singular edges: a wave in a uniform stream comes back to where it was.
#include "core/comm/halo.hpp"
#include "core/grid/pipe.hpp"
#include "physics/fluid/advection_lcsi.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

/// Root mean square error of sin(2 pi x) carried once along a pipe of length 1 at 0.4 cells per step.
double wave_error(int axial_cells)
{
    core::Pipe pipe;
    pipe.diameter = pipe.length = 1;
    pipe.axial_cells = axial_cells;
    pipe.blocks_along = 2;
    const core::Mesh mesh(core::make_pipe(pipe), 0, 1);
    const core::HaloExchange exchange(mesh, core::Communicator::self(), 3, 3, core::HaloShape::full);
    core::VectorField q({"q", "", 3, false}, mesh.own_cells()), moved({"moved", "", 3, false}, mesh.own_cells()),
        displacement({"displacement", "", 0, false}, mesh.own_cells());
    for (auto* field : {&q, &moved, &displacement}) field->allocate();
    const auto each_cell = [&](auto body) {
        for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
            core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) { body(b, i, j, k); });
    };
    const auto wave = [&](core::LocalBlock b, int i, int j, int k) {
        return std::sin(2 * std::numbers::pi * mesh.geometry(b).centre(i, j, k).x());
    };
    each_cell([&](core::LocalBlock b, int i, int j, int k) {
        q.on(b).x(i, j, k) = wave(b, i, j, k);
        displacement.on(b).y(i, j, k) = 0.4; // the pipe runs along j
    });
    for (int step = 0; step < 5 * axial_cells / 2; ++step) {
        exchange.fill(q);
        for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
            physics::advect(mesh.geometry(b), q.on(b), displacement.on(b), physics::singular_axes(mesh.topology(), b), moved.on(b));
        std::swap(q, moved);
    }
    double sum = 0, cells = 0;
    each_cell([&](core::LocalBlock b, int i, int j, int k) {
        sum += std::pow(q.on(b).x(i, j, k) - wave(b, i, j, k), 2);
        ++cells;
    });
    return std::sqrt(sum / cells);
}

} // namespace

TEST_CASE("a wave along the pipe keeps third order, also beside singular edges")
{
    const double coarse = wave_error(16), fine = wave_error(32);
    MESSAGE("error with 16 cells ", coarse, ", with 32 ", fine);
    CHECK(std::log2(coarse / fine) > 2.8);
    CHECK(fine < 5e-3);
}
