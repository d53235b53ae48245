// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Scalars through sides whose points do not match, in the ratios 2:3, 1:2 and 1:4: carried and spread to second order, never outside
// their range, and nothing made or lost (NUMERICS B8, D26).
#include "tests/support/joined_boxes.hpp"
#include "tests/support/scalar_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

const Vec3 stream(1, 0.5, 0.25);

/// Cells of the second half for each of the first along the interface: along / per.
struct Ratio {
    int along, per;
};

core::MultiBlock halves(int n, Ratio ratio)
{
    const int fine = n * ratio.along / ratio.per;
    return test::wavy_halves({{n / 2, n, n}, {n / 2, fine, fine}}, 0.2, 0);
}

double wave(const Vec3& x) { return std::sin(x.x()) * std::cos(x.y()) + 0.5 * std::sin(x.x() + x.z()); }

/// After a time in which the wave goes through both sides.
double carried_error(int n, Ratio ratio)
{
    test::ScalarRun run(halves(n, ratio));
    run.start(wave, stream);
    const double time = std::numbers::pi;
    const int steps = 2 * n;
    for (int s = 0; s < steps; ++s) run.carry(time / steps);
    return run.error([&](const Vec3& x) { return wave(x - time * stream); }, 1);
}

double spread_error(int n, Ratio ratio)
{
    test::ScalarRun run(halves(n, ratio));
    run.start(wave, Vec3(0, 0, 0));
    const double before = run.amount(), time = 0.1;                               // both waves have wave numbers of square 2
    const int across = n * ratio.along / ratio.per, steps = across * across / 64; // so short that half of it is explicit
    for (int s = 0; s < steps; ++s) run.diffuse(time / steps, 1.0);
    CHECK(std::abs(run.amount() - before) < 1e-13); // round-off, of values of 1
    return run.error([&](const Vec3& x) { return std::exp(-2 * time) * wave(x); });
}

} // namespace

TEST_CASE("waves are carried through sides whose points do not match to second order")
{
    for (const Ratio ratio : {Ratio{3, 2}, {2, 1}, {4, 1}}) {
        const double coarse = carried_error(8, ratio), fine = carried_error(16, ratio);
        MESSAGE(ratio.per << ":" << ratio.along << ": errors " << coarse << ", " << fine << ", order " << std::log2(coarse / fine));
        CHECK(std::log2(coarse / fine) > 1.8);
    }
}

TEST_CASE("they spread through them to second order")
{
    for (const Ratio ratio : {Ratio{3, 2}, {2, 1}, {4, 1}}) {
        const double coarse = spread_error(8, ratio), fine = spread_error(16, ratio);
        MESSAGE(ratio.per << ":" << ratio.along << ": errors " << coarse << ", " << fine << ", order " << std::log2(coarse / fine));
        CHECK(std::log2(coarse / fine) > 1.8);
    }
}

TEST_CASE("a step that goes through them stays between its values, and its amount to round-off")
{
    for (const double turn : {0.0, 37.0}) {
        test::ScalarRun run(test::wavy_halves({{6, 8, 8}, {8, 12, 20}}, 0.3, turn));
        run.start([](const Vec3& x) { return (x - Vec3(1, 1, 1)).norm() < 2 ? 1.0 : 0.0; }, stream);
        const double before = run.amount();
        for (int s = 0; s < 20; ++s) run.carry(0.3);
        CHECK(run.parts() > 1);         // more than a cell holds would leave it
        CHECK(run.range()[0] > -1e-13); // round-off of a hundred parts
        CHECK(run.range()[1] < 1 + 1e-13);
        CHECK(std::abs(run.amount() - before) < 1e-13 * before);
    }
}

TEST_CASE("what is the same everywhere stays so")
{
    test::ScalarRun run(test::wavy_halves({{5, 7, 6}, {4, 11, 13}}, 0.3, 37));
    run.start([](const Vec3&) { return 3.0; }, stream);
    for (int s = 0; s < 5; ++s) {
        run.carry(0.5);
        run.diffuse(0.5, 1.0);
    }
    CHECK(run.range()[0] > 3 - 1e-12); // round-off
    CHECK(run.range()[1] < 3 + 1e-12);
}
