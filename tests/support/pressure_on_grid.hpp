// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pressure equation with its full operator, on any grid between walls, with sources of both signs.
#include "core/grid/mesh.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/pressure_system.hpp"
#include "tasks/exchange_filler.hpp"
#include <cmath>

namespace test {

class PressureOnGrid {
public:
    /// @param wave_length  Of what the sources are along x, beside what is random in them.
    /// @param accuracy     Of solutions: residual over the sources.
    PressureOnGrid(core::MultiBlock grid, double wave_length, double accuracy = 1e-8)
        : ranks_(core::Communicator::self()),
          mesh_(std::move(grid), 0, 1),
          filler_(mesh_, ranks_),
          walls_(physics::make_walls(mesh_, {})),
          system_({mesh_, walls_, filler_}, ranks_, tolerances(accuracy)),
          source_({"source", "m3/s", 0, true}, mesh_.own_cells()),
          through_({"throughput", "m3/s", 0, true}, mesh_.own_cells()),
          pressure_({"pressure", "m2/s", 1, true}, mesh_.own_cells())
    {
        for (auto* field : {&source_, &through_, &pressure_}) field->allocate();
        fill_sources(wave_length);
    }
    PressureOnGrid(const PressureOnGrid&) = delete;
    PressureOnGrid& operator=(const PressureOnGrid&) = delete;

    /// An iteration has two V-cycles and two products.
    const physics::KrylovReport& solve(const core::Team& team)
    {
        tasks::run(ranks_, team, [&](tasks::Lane& lane) { return system_.solve(lane, {source_, through_}, pressure_); });
        return system_.report();
    }
    /// Sources, and the pressure of the last solve: block by block.
    [[nodiscard]] std::vector<double> sources() const { return values_of(source_); }
    [[nodiscard]] std::vector<double> solution() const { return values_of(pressure_); }
    [[nodiscard]] const core::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const core::Communicator& ranks() const { return ranks_; }
    [[nodiscard]] physics::PressureSystem& system() { return system_; }

private:
    static physics::FluidTolerances tolerances(double accuracy)
    {
        physics::FluidTolerances t;
        t.pressure = 1;
        t.pressure_change = accuracy;
        return t;
    }
    [[nodiscard]] std::vector<double> values_of(const core::ScalarField& field) const
    {
        std::vector<double> values;
        each([&](core::LocalBlock b, core::Index3 c) { values.push_back(field.on(b)(c.i, c.j, c.k)); });
        return values;
    }
    template <class Body>
    void each(Body body) const
    {
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b)
            core::for_each_cell(mesh_.geometry(b).cells, [&](int i, int j, int k) { body(b, core::Index3{i, j, k}); });
    }
    void fill_sources(double wave_length)
    {
        unsigned random = 1;
        double sum = 0, cells = 0;
        each([&](core::LocalBlock b, core::Index3 c) {
            random = random * 1664525U + 1013904223U;
            const double wave = std::sin(mesh_.geometry(b).centre(c.i, c.j, c.k).x() / wave_length);
            sum += source_.on(b)(c.i, c.j, c.k) = std::ldexp(double(random), -32) - 0.5 + wave;
            through_.on(b)(c.i, c.j, c.k) = 1;
            ++cells;
        });
        each([&](core::LocalBlock b, core::Index3 c) { source_.on(b)(c.i, c.j, c.k) -= sum / cells; });
    }

    core::Communicator ranks_;
    core::Mesh mesh_;
    tasks::ExchangeFiller filler_;
    std::vector<physics::BlockWalls> walls_;
    physics::PressureSystem system_;
    core::ScalarField source_, through_, pressure_;
};

} // namespace test
