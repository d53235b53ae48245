// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Flow in a square cavity under a lid that moves, at Re = 100, against a solution of stream function and vorticity on 256 x 256
// points that agrees with Botella & Peyret (1998) within 1e-5 (NUMERICS C1.4).
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

/// Place on the middle line, velocity across or along it.
struct Reference {
    double at, velocity;
};
constexpr std::array<Reference, 8> along_lid{{{0.0547, -0.03723},
                                              {0.1719, -0.10174},
                                              {0.2813, -0.15767},
                                              {0.4531, -0.21397},
                                              {0.6172, -0.13880},
                                              {0.7344, 0.00418},
                                              {0.8516, 0.23654},
                                              {0.9531, 0.69101}}};
constexpr std::array<Reference, 7> down{
    {{0.0625, 0.09480}, {0.1563, 0.16482}, {0.2344, 0.17955}, {0.5, 0.05754}, {0.8047, -0.25353}, {0.9063, -0.17707}, {0.9531, -0.09339}}};

/// The velocity in the middle between two columns (or rows) of cells, at a place along them: cubic through four cells.
double on_middle_line(const test::FluidRun& run, int cells, int component, double place)
{
    const auto at = [&](int n) {
        const auto value = [&](int beside) {
            return component == 0 ? run.velocity(0, beside, n, 0).x() : run.velocity(0, n, beside, 0).y();
        };
        return 0.5 * (value(cells / 2 - 1) + value(cells / 2));
    };
    const double s = place * cells - 0.5;
    const int first = std::clamp(int(std::floor(s)) - 1, 0, cells - 4);
    double sum = 0;
    for (int n = 0; n < 4; ++n) {
        double weight = 1;
        for (int m = 0; m < 4; ++m)
            if (m != n) weight *= (s - first - m) / (n - m);
        sum += weight * at(first + n);
    }
    return sum;
}

/// Root mean square difference on both middle lines, over the speed of the lid.
double cavity_error(int cells)
{
    physics::FluidParameters p;
    p.viscosity = 1e-2;
    p.boundaries["y_high"].velocity = Vec3(1, 0, 0);
    const core::Box box{{0, 0, 0}, {1, 1, 1.0 / cells}, {cells, cells, 1}, {1, 1, 1}, {false, false, true}};
    test::FluidRun run(core::make_box(box), p);
    run.start([](const Vec3&) { return Vec3(0, 0, 0); });
    const double dt = 0.8 / cells;
    while (run.time() < 20) run.step(dt); // changes by less than 1e-5 after that
    double sum = 0;
    for (const Reference& r : along_lid) sum += std::pow(on_middle_line(run, cells, 0, r.at) - r.velocity, 2);
    for (const Reference& r : down) sum += std::pow(on_middle_line(run, cells, 1, r.at) - r.velocity, 2);
    return std::sqrt(sum / (along_lid.size() + down.size()));
}

} // namespace

TEST_CASE("the flow in a cavity under a moving lid, to second order")
{
    const double coarse = cavity_error(24), fine = cavity_error(48);
    MESSAGE("error over the lid's speed, 24 and 48 cells: ", coarse, ", ", fine);
    CHECK(fine < 2e-3);
    CHECK(std::log2(coarse / fine) > 1.7); // the lid's corners, where the velocity jumps, cost a little
}
