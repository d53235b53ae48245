// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Passive scalars: carried to second order on curvilinear grids, never outside their range, and nothing made or lost.
#include "tests/support/scalar_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

/// Turns about the axis of a pipe once in 2 pi, and flows along it.
Vec3 turning(const Vec3& x) { return {-0.5 * x.tail<2>().squaredNorm(), -0.15 * x.z(), 0.15 * x.y()}; }

double hill(const Vec3& x, const Vec3& middle, double width) { return std::exp(-(x - middle).squaredNorm() / (width * width)); }
double hill_beside_axis(const Vec3& x) { return hill({0, x.y(), x.z()}, {0, 0.4, 0}, 0.3); }
double cylinder_beside_axis(const Vec3& x) { return std::hypot(x.y() - 0.4, x.z()) < 0.3 ? 1.0 : 0.0; }

/// Error after one turn, in the mean, with a Courant number of about 0.7 over the butterfly's edges.
double turning_error(int across, double power)
{
    test::ScalarRun run(test::pipe_across(across, 2.0, 4, 1));
    run.start(hill_beside_axis, turning);
    const int steps = 10 * across;
    for (int n = 0; n < steps; ++n) run.carry(2 * std::numbers::pi / steps);
    const double error = run.error(hill_beside_axis, power);
    MESSAGE(across, " cells across: ", error, ", largest value ", run.range()[1], ", parts ", run.parts());
    return error;
}

core::MultiBlock wavy_box(int cells)
{
    const double side = 2 * std::numbers::pi;
    const core::Box box{{0, 0, 0}, {side, side, side / cells * 4}, {cells, cells, 4}, {2, 2, 1}, {true, true, true}};
    return core::make_box(box, [](const Vec3& x) { return test::wavy(x, 0.3, 0.0); });
}

} // namespace

TEST_CASE("a turning hill keeps its shape on the butterfly grid, to second order")
{
    const double coarse = turning_error(24, 1), fine = turning_error(48, 1);
    CHECK(std::log2(coarse / fine) > 1.9);
}

TEST_CASE("waves cross a wavy box to second order")
{
    const auto error = [](int cells) {
        test::ScalarRun run(wavy_box(cells));
        const auto wave = [](const Vec3& x) { return std::sin(x.x()) * std::cos(x.y()); };
        run.start(wave, [](const Vec3& x) { return Vec3(0, 0, x.y() - 0.5 * x.x()); });
        // Velocity (1, 1/2): after 4 pi all is where it was.
        for (int n = 0; n < 4 * cells; ++n) run.carry(4 * std::numbers::pi / (4 * cells));
        MESSAGE(cells, " cells: ", run.error(wave, 1), " in the mean, ", run.error(wave, 2), " in squares, parts ", run.parts());
        return run.error(wave, 1);
    };
    CHECK(std::log2(error(16) / error(32)) > 1.9);
}

TEST_CASE("a step stays between its values, and its amount to round-off, however long the step in time")
{
    for (const int steps : {400, 40}) {
        test::ScalarRun run(test::pipe_across(24, 2.0, 4, 1));
        run.start(cylinder_beside_axis, turning);
        const double before = run.amount();
        for (int n = 0; n < steps; ++n) run.carry(2 * std::numbers::pi / steps);
        MESSAGE("error in the mean: ", run.error(cylinder_beside_axis, 1), ", parts ", run.parts());
        CHECK(run.range()[0] > -1e-13); // round-off of 400 to 1600 parts
        CHECK(run.range()[1] < 1 + 1e-13);
        CHECK(std::abs(run.amount() - before) < 1e-13 * before);
    }
}

TEST_CASE("a hill spreads as the heat kernel does, to second order, and its amount stays")
{
    const auto error = [](int cells) {
        test::ScalarRun run(wavy_box(cells));
        const Vec3 middle(std::numbers::pi, std::numbers::pi, 0);
        // exp(-r^2 / s^2) in a plane: s^2 grows by 4 D t, the top falls as s0^2 / s^2.
        const auto spread = [&](double time) {
            return [=](const Vec3& x) { return hill({x.x(), x.y(), 0}, middle, std::sqrt(0.36 + 4 * time)) * 0.36 / (0.36 + 4 * time); };
        };
        run.start(spread(0), [](const Vec3&) { return Vec3(0, 0, 0); });
        const double before = run.amount();
        const int steps = cells / 2;
        for (int n = 0; n < steps; ++n) run.diffuse(0.06 / steps, 1.0);
        CHECK(std::abs(run.amount() - before) < 1e-13 * before);
        MESSAGE(cells, " cells: ", run.error(spread(0.06)), ", products ", run.products());
        return run.error(spread(0.06));
    };
    CHECK(std::log2(error(32) / error(64)) > 1.8); // 1.79 from 24 to 48, 1.86 here: it tends to 2
}

TEST_CASE("a step that diffuses for long becomes flat without ringing")
{
    test::ScalarRun run(test::pipe_across(16, 2.0, 4, 1));
    run.start(cylinder_beside_axis, turning);
    const double before = run.amount();
    run.diffuse(1e-3, 1.0);
    CHECK(run.range()[0] > -0.02); // cross terms of skewed cells at a jump: they are not limited
    for (int n = 0; n < 5; ++n) run.diffuse(100.0, 1.0);
    CHECK(run.range()[1] - run.range()[0] < 1e-9);
    CHECK(std::abs(run.amount() - before) < 1e-12 * before); // of 1e5 times what the cells hold, through their faces
}

TEST_CASE("a dye that spreads across all cells in a step does so in few products, on slanted cells too")
{
    const double side = 2 * std::numbers::pi, spread = 100; // diffusivity times step, of a wave of length 2 pi
    for (const int slope : {0, 4}) {
        const int cells = 32, rows = std::max(1, slope) * cells;
        const core::Box box{{0, 0, 0}, {side, side, side / cells}, {cells, rows, 1}, {2, 2, 1}, {true, true, true}};
        auto grid = core::make_box(box, [=](const Vec3& x) { return Vec3(x.x() + slope * x.y(), x.y(), x.z()); });
        grid.periods[1] = Vec3(slope * side, side, 0);
        test::ScalarRun run(std::move(grid));
        const auto wave = [](const Vec3& x) { return 1 + std::cos(x.x()) * std::sin(x.y()); };
        run.start(wave, [](const Vec3&) { return Vec3(0, 0, 0); });
        run.diffuse(1.0, spread);
        const double left = 1 / (1 + 2 * spread), error = run.error([=](const Vec3&x) { return 1 + left * (wave(x) - 1); });
        MESSAGE("slope ", slope, ": ", run.products(), " products, error ", error / left, " of what is left");
        CHECK(error < (slope == 0 ? 0.01 : 0.1) * left); // of second-order differences, 32 of them along a wave
        CHECK(run.products() < (slope == 0 ? 20 : 200)); // to 1e-12; Jacobi's preconditioner gives up after 400
    }
}
