// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/coupling/filter.hpp"
#include "tests/support/conduction_boxes.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

const core::SerialTeam serial;

core::ScalarField scalar(const std::vector<core::Extents>& cells)
{
    core::ScalarField f({"density", "1/m3", 0, false}, cells);
    f.allocate();
    return f;
}

/// Blocks tied at random, with random volumes.
struct RandomCase {
    test::ConductionProblem problem;
    core::ScalarField volume;
    physics::Filter filter;

    explicit RandomCase(unsigned seed)
        : problem(test::random_blocks(seed, 10.0)), volume(scalar(problem.topology.cells)), filter(problem.topology, {.bandwidth = 0.7})
    {
        for (std::size_t b = 0; b < volume.blocks(); ++b)
            for (std::size_t c = 0; c < volume.data(int(b), 0).size(); ++c) volume.data(int(b), 0)[c] = 1.0 + 0.1 * double(c % 7);
        filter.load(serial, problem.coefficients(), volume);
        filter.set_bound(filter.eigenvalue_bound());
    }
    [[nodiscard]] core::ScalarField field(unsigned seed) const
    {
        auto f = scalar(problem.topology.cells);
        std::mt19937 random(seed);
        for (std::size_t b = 0; b < f.blocks(); ++b)
            for (double& x : f.data(int(b), 0)) x = double(random()) / 4294967296.0;
        return f;
    }
    /// Volume-weighted product.
    [[nodiscard]] double product(const core::ScalarField& x, const core::ScalarField& y) const
    {
        double sum = 0.0;
        for (std::size_t b = 0; b < x.blocks(); ++b)
            for (std::size_t c = 0; c < x.data(int(b), 0).size(); ++c)
                sum += volume.data(int(b), 0)[c] * x.data(int(b), 0)[c] * y.data(int(b), 0)[c];
        return sum;
    }
};

} // namespace

TEST_CASE("the filter is symmetric in the volume-weighted product, conserves the sum and keeps constants")
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        RandomCase c(seed);
        const auto x = c.field(seed), y = c.field(seed + 50);
        auto one = scalar(c.problem.topology.cells), sx = one, sy = one, s1 = one;
        for (std::size_t b = 0; b < one.blocks(); ++b)
            for (double& v : one.data(int(b), 0)) v = 1.0;
        c.filter.put(serial, 0, x);
        c.filter.put(serial, 1, y);
        c.filter.put(serial, 2, one);
        c.filter.run(serial, 3);
        c.filter.take(serial, 0, sx);
        c.filter.take(serial, 1, sy);
        c.filter.take(serial, 2, s1);
        CHECK(c.filter.degree() > 5);
        // Round-off of some ten passes over some 300 cells.
        CHECK(std::abs(c.product(x, sy) - c.product(sx, y)) < 1e-13 * c.product(x, y));
        CHECK(std::abs(c.product(one, sx) - c.product(one, x)) < 1e-14 * c.product(one, x));
        for (std::size_t b = 0; b < one.blocks(); ++b)
            for (double v : s1.data(int(b), 0)) CHECK(std::abs(v - 1.0) < 1e-14);
    }
}

TEST_CASE("the filter is the exponential of the assembled Laplacian")
{
    RandomCase c(3);
    const auto n = Eigen::Index(physics::cell_count(c.problem.topology));
    Eigen::VectorXd root(n); // square roots of the volumes make the matrix symmetric
    const auto x = c.field(9);
    auto y = x;
    Eigen::VectorXd in(n);
    for (int b = 0; b < int(x.blocks()); ++b)
        for (std::size_t k = 0; k < x.data(b, 0).size(); ++k) {
            root[c.problem.row(b, int(k))] = std::sqrt(c.volume.data(b, 0)[k]);
            in[c.problem.row(b, int(k))] = x.data(b, 0)[k];
        }
    const Eigen::MatrixXd a = root.cwiseInverse().asDiagonal() * c.problem.dense() * root.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
    const Eigen::VectorXd decay = (-0.25 * 0.7 * 0.7 * eigen.eigenvalues().array()).exp();
    const Eigen::VectorXd expected = root.cwiseInverse().asDiagonal() * (eigen.eigenvectors()
                                   * (decay.asDiagonal() * (eigen.eigenvectors().transpose() * (root.asDiagonal() * in))));
    c.filter.put(serial, 0, x);
    c.filter.run(serial, 1);
    c.filter.take(serial, 0, y);
    double worst = 0.0;
    for (int b = 0; b < int(y.blocks()); ++b)
        for (std::size_t k = 0; k < y.data(b, 0).size(); ++k)
            worst = std::max(worst, std::abs(y.data(b, 0)[k] - expected[c.problem.row(b, int(k))]));
    // The series is cut at 1e-6 of the norm of the field, some 17 for 300 cells of about 1.
    CHECK(worst < 2e-5);
}

TEST_CASE("a filled cell becomes a Gaussian of the bandwidth and goes below zero by no more than stated")
{
    const int n = 33;
    const double h = 1e-3, bandwidth = 4e-3;
    const test::BoxGrid grid{{test::uniform(n, n * h), test::uniform(n, n * h), test::uniform(n, n * h)}, {3, 1, 1}};
    const auto p = test::box_problem(grid, [](double, double, double) { return 1.0; });
    auto volume = scalar(p.topology.cells), density = volume;
    for (std::size_t b = 0; b < volume.blocks(); ++b)
        for (double& v : volume.data(int(b), 0)) v = h * h * h;
    density.on(1)(5, 16, 16) = 1.0;
    physics::Filter filter(p.topology, {.bandwidth = bandwidth});
    filter.load(serial, p.coefficients(), volume);
    filter.set_bound(filter.eigenvalue_bound());
    filter.put(serial, 0, density);
    filter.run(serial, 1);
    filter.take(serial, 0, density);
    double lowest = 0.0, moment = 0.0, sum = 0.0, worst = 0.0;
    const double peak = std::pow(h / bandwidth, 3) / std::pow(std::numbers::pi, 1.5);
    for (int b = 0; b < 3; ++b)
        core::for_each_cell(p.topology.cells[std::size_t(b)], [&](int i, int j, int k) {
            const double x = h * (11 * b + i - 16), y = h * (j - 16), z = h * (k - 16), value = density.on(b)(i, j, k);
            lowest = std::min(lowest, value);
            sum += value;
            moment += value * x * x;
            worst = std::max(worst, std::abs(value - peak * std::exp(-(x * x + y * y + z * z) / (bandwidth * bandwidth))));
        });
    MESSAGE("degree " << filter.degree() << ", lowest " << lowest << ", deviation from the Gaussian " << worst / peak);
    CHECK(lowest >= -1e-6);
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-13));
    // The second moment of the discrete kernel is exactly bandwidth^2 / 2; the cut of the series shows in it.
    CHECK(moment == doctest::Approx(0.5 * bandwidth * bandwidth).epsilon(1e-3));
    // The discrete kernel differs from the Gaussian by terms of (h / bandwidth)^2 = 1/16.
    CHECK(worst < 0.0625 * 1.5 * peak);
}

TEST_CASE("a bandwidth far beyond the thinnest cells is refused")
{
    RandomCase c(1);
    physics::Filter filter(c.problem.topology, {.bandwidth = 700.0, .most_degree = 100});
    filter.load(serial, c.problem.coefficients(), c.volume);
    CHECK_THROWS_AS(filter.set_bound(filter.eigenvalue_bound()), core::ConfigError);
}
