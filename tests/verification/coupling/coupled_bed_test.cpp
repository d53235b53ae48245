// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Beds: at rest in still water, with closed books of momentum and volume, and as dense as they are.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

TEST_CASE("a settled bed in still water comes to rest, and all that moves it is balanced")
{
    for (const io::CouplingMode mode : {io::CouplingMode::pipelined, io::CouplingMode::coarse, io::CouplingMode::iterated}) {
        CoupledBox box;
        box.gravity = {0, -9.81, 0};
        box.settle = 1.0;
        box.mode = mode;
        CoupledRun run(box, 250);
        run.stop_grains();
        run.start();
        const double weight = 9.81 * run.grains().mass[0] / 2;
        for (int n = 1; n <= 300; ++n) {
            run.step();
            if (n == 1 || n % 100 == 0)
                std::printf("bed; %s, step %d: fluid %.1e, grains %.1e m/s, net force %.1e of the weight\n",
                            run.world().mode_reason().c_str(), n, run.fluid_deviation(), run.grain_deviation(),
                            run.net_force_over_weight(weight));
        }
        // The velocities that naive lagging, which amplifies 1.3 times a step here, would reach: none. Contacts settle to round-off.
        CHECK(run.fluid_deviation() < 1e-6);
        CHECK(run.net_force_over_weight(weight) < 1e-6);
    }
}

TEST_CASE("momentum and volume of a stirred suspension are accounted for in every step")
{
    for (const io::CouplingMode mode : every_mode) {
        CoupledBox box;
        box.size = {16e-3, 16e-3, 16e-3};
        box.cells = {8, 8, 8};
        box.blocks = {2, 1, 1};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.gravity = {0, -9.81, 0};
        box.pressure_gradient = 1e4;
        box.viscosity = 1e-5;
        box.mode = mode;
        CoupledRun run(box, mode == io::CouplingMode::concurrent ? 80 : 150); // more would be too dense for it
        run.start();
        io::MomentumLedger books(run.world());
        double defect = 0, exchange = 0, volume = 0;
        for (int n = 0; n < 60; ++n) {
            run.step();
            books.update();
            defect = std::max(defect, books.defect());
            exchange = std::max(exchange, books.exchange_defect());
            volume = std::max(volume, std::abs((run.fluid_volume() + run.solid_volume()) / box.size.prod() - 1));
        }
        std::printf("books; %s: exchange %.1e, momentum %.1e, volume %.1e; fluid %.2f m/s\n", run.world().mode_reason().c_str(), exchange,
                    defect, volume, run.fluid_deviation());
        CHECK(run.world().mode_reason().ends_with("as the scene asks"));
        // Sums of a thousand terms in another order on the two sides.
        CHECK(exchange < 1e-12);
        CHECK(defect < 1e-12);
        CHECK(volume < 1e-12);
    }
}

TEST_CASE("a bed of fine grains, whose drag is too stiff for one pass, is iterated and comes to rest")
{
    for (const io::CouplingMode mode : {io::CouplingMode::automatic, io::CouplingMode::pipelined}) {
        CoupledBox box;
        box.size = {0.4e-3, 0.6e-3, 0.4e-3};
        box.diameter = 5e-5;
        box.density_ratio = 2.65;
        box.gravity = {0, -9.81, 0};
        box.stiffness = 0.5;
        box.settle = 0.05;
        box.mode = mode;
        CoupledRun run(box, 250);
        run.stop_grains();
        run.start();
        double fastest = 0;
        std::vector<std::string> warnings;
        for (int n = 1; n <= 60; ++n) {
            run.step();
            for (const auto& w : run.world().take_warnings()) warnings.push_back(w);
            fastest = std::max(fastest, run.grain_deviation());
        }
        const auto numbers = run.world().coupling()->stability(box.dt);
        std::printf("fine bed, %s: b %.1f, fastest %.1e, at the end grains %.1e, fluid %.1e m/s; %s\n",
                    mode == io::CouplingMode::automatic ? "auto" : "pipelined", numbers.stiffness, fastest, run.grain_deviation(),
                    run.fluid_deviation(), warnings.empty() ? "no warning" : warnings[0].c_str());
        CHECK(numbers.stiffness > 10);
        CHECK(warnings.size() == (mode == io::CouplingMode::automatic ? 1 : 0));
        // One grain alone settles at 2.2 mm/s; what is left at the end is a thousandth of what gravity gives in one step.
        CHECK(fastest < 2.2e-3);
        CHECK(run.grain_deviation() < 1e-5);
    }
}

TEST_CASE("the filter leaves a bed as dense as counted")
{
    for (const double width : {1.5, 2.0, 4.0}) {
        CoupledBox box;
        box.size = {20e-3, 32e-3, 20e-3};
        box.cells = {10, 16, 10};
        box.gravity = {0, -9.81, 0};
        box.settle = 0.5;
        box.filter = width;
        box.periodic = {io::Axis::x, io::Axis::z};
        CoupledRun run(box, 800);
        run.start();
        const double low = 4e-3, high = 10e-3;
        const auto cap = [](double r, double h) { // volume of a sphere below height h over its lowest point
            h = std::clamp(h, 0.0, 2 * r);
            return std::numbers::pi * h * h * (r - h / 3);
        };
        double counted = 0, top = 0;
        for (int g = 0; g < run.grains().owned; ++g) {
            const double y = run.grains().position_of(g).y(), r = run.grains().radius[std::size_t(g)];
            counted += cap(r, high - y + r) - cap(r, low - y + r);
            top = std::max(top, y);
        }
        counted /= (high - low) * box.size.x() * box.size.z();
        double filtered = 0;
        int cells = 0;
        core::for_each_cell(run.world().mesh().geometry(0).cells, [&](int i, int j, int k) {
            const double y = run.world().mesh().geometry(0).centre(i, j, k).y();
            if (y < low || y > high) return;
            filtered += 1 - run.world().coupling()->fields().fraction.on(0)(i, j, k);
            ++cells;
        });
        filtered /= cells;
        std::printf("filter %.1f d: bed %.1f mm high, packing counted %.4f, filtered %.4f, ratio %.3f\n", width, 1e3 * top, counted,
                    filtered, filtered / counted);
        if (width <= 2.0) CHECK(std::abs(filtered / counted - 1) < 0.05); // the gate of NUMERICS B3
    }
}
