// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/coupling/filter.hpp"
#include "tests/support/conduction_boxes.hpp"
#include "tests/support/relative.hpp"
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

    RandomCase(unsigned seed, int most_steps)
        : problem(test::random_blocks(seed, 10.0)),
          volume(scalar(problem.topology.cells)),
          filter(problem.topology, {.bandwidth = 0.7, .most_steps = most_steps})
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
    /// All fields filtered at once.
    void apply(std::vector<core::ScalarField>& fields)
    {
        const auto field = [&](core::LocalBlock b, int n) { return fields[std::size_t(n)].on(b); };
        filter.put(serial, int(fields.size()), field);
        filter.run(serial, int(fields.size()));
        filter.take(serial, int(fields.size()), field);
    }
    /// Inverse square roots of the volumes, and the Laplacian made symmetric with them.
    [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::MatrixXd> laplacian() const
    {
        Eigen::VectorXd root(Eigen::Index(physics::cell_count(problem.topology)));
        for (int b = 0; b < int(volume.blocks()); ++b)
            for (std::size_t k = 0; k < volume.data(b, 0).size(); ++k) root[problem.row(b, int(k))] = 1.0 / std::sqrt(volume.data(b, 0)[k]);
        return {root, root.asDiagonal() * problem.dense() * root.asDiagonal()};
    }
    [[nodiscard]] Eigen::VectorXd vector(const core::ScalarField& x) const
    {
        Eigen::VectorXd v(Eigen::Index(physics::cell_count(problem.topology)));
        for (int b = 0; b < int(x.blocks()); ++b)
            for (std::size_t k = 0; k < x.data(b, 0).size(); ++k) v[problem.row(b, int(k))] = x.data(b, 0)[k];
        return v;
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
    for (const int most_steps : {0, 1000}) { // Chebyshev terms, explicit steps
        for (unsigned seed = 1; seed <= 5; ++seed) {
            RandomCase c(seed, most_steps);
            const auto x = c.field(seed), y = c.field(seed + 50);
            auto one = scalar(c.problem.topology.cells);
            for (std::size_t b = 0; b < one.blocks(); ++b)
                for (double& v : one.data(int(b), 0)) v = 1.0;
            std::vector<core::ScalarField> filtered{x, y, one};
            c.apply(filtered);
            const auto &sx = filtered[0], &sy = filtered[1], &s1 = filtered[2];
            CHECK(c.filter.degree() > (most_steps == 0 ? 5 : 3));
            // Round-off of some ten passes over some 300 cells.
            CHECK(std::abs(c.product(x, sy) - c.product(sx, y)) < 1e-13 * c.product(x, y));
            CHECK(std::abs(c.product(one, sx) - c.product(one, x)) < 1e-14 * c.product(one, x));
            for (std::size_t b = 0; b < one.blocks(); ++b)
                for (double v : s1.data(int(b), 0)) CHECK(std::abs(v - 1.0) < 1e-14);
        }
    }
}

TEST_CASE("the Chebyshev filter is the exponential of the assembled Laplacian")
{
    RandomCase c(3, 0);
    const auto [root, a] = c.laplacian();
    std::vector<core::ScalarField> field{c.field(9)};
    const Eigen::VectorXd in = c.vector(field[0]).cwiseQuotient(root);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
    const Eigen::VectorXd decay = (-0.25 * 0.7 * 0.7 * eigen.eigenvalues().array()).exp();
    const Eigen::VectorXd expected =
        root.asDiagonal() * (eigen.eigenvectors() * (decay.asDiagonal() * (eigen.eigenvectors().transpose() * in)));
    c.apply(field);
    // The series is cut at 1e-6 of the norm of the field, some 17 for 300 cells of about 1.
    CHECK((c.vector(field[0]) - expected).cwiseAbs().maxCoeff() < 2e-5);
}

TEST_CASE("the filter of explicit steps is their product with the assembled Laplacian and takes over the whole pseudo-time")
{
    RandomCase c(3, 1000);
    const auto [root, a] = c.laplacian();
    std::vector<core::ScalarField> field{c.field(9)};
    Eigen::VectorXd expected = c.vector(field[0]).cwiseQuotient(root);
    const double largest = a.diagonal().maxCoeff(), total = 0.25 * 0.7 * 0.7 * largest;
    double sum = 0.0;
    for (const double share : physics::diffusion_steps(total)) {
        CHECK(share <= 1.0); // a step of more would be negative in the fullest cell
        expected -= share / largest * (a * expected);
        sum += share;
    }
    CHECK(sum == test::relative(total).epsilon(1e-14));
    c.apply(field);
    // Round-off of some ten steps.
    CHECK((c.vector(field[0]) - root.cwiseProduct(expected)).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("a filled cell becomes a Gaussian of the bandwidth and goes below zero by no more than stated")
{
    const int n = 33;
    const double h = 1e-3, bandwidth = 4e-3;
    const test::BoxGrid grid{{test::uniform(n, n * h), test::uniform(n, n * h), test::uniform(n, n * h)}, {3, 1, 1}};
    const auto p = test::box_problem(grid, [](double, double, double) { return 1.0; });
    auto volume = scalar(p.topology.cells);
    for (std::size_t b = 0; b < volume.blocks(); ++b)
        for (double& v : volume.data(int(b), 0)) v = h * h * h;
    for (const int most_steps : {0, 1000}) { // Chebyshev terms, explicit steps
        auto density = scalar(p.topology.cells);
        density.on(1)(5, 16, 16) = 1.0;
        physics::Filter filter(p.topology, {.bandwidth = bandwidth, .most_steps = most_steps});
        filter.load(serial, p.coefficients(), volume);
        filter.set_bound(filter.eigenvalue_bound());
        filter.put(serial, 1, [&](core::LocalBlock b, int) { return density.on(b); });
        filter.run(serial, 1);
        filter.take(serial, 1, [&](core::LocalBlock b, int) { return density.on(b); });
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
        CHECK(lowest >= (most_steps == 0 ? -1e-6 : 0.0));
        CHECK(sum == test::relative(1.0).epsilon(1e-13));
        // The second moment of the discrete kernel is exactly bandwidth^2 / 2, but for what walls reflect; the cut of the
        // Chebyshev series shows.
        CHECK(moment == test::relative(0.5 * bandwidth * bandwidth).epsilon(most_steps == 0 ? 1e-3 : 1e-6));
        // The discrete kernel differs from the Gaussian by terms of (h / bandwidth)^2 = 1/16.
        CHECK(worst < 0.0625 * 1.5 * peak);
    }
}

TEST_CASE("a bandwidth far beyond the thinnest cells is refused")
{
    RandomCase c(1, 100);
    physics::Filter filter(c.problem.topology, {.bandwidth = 700.0, .most_degree = 100});
    filter.load(serial, c.problem.coefficients(), c.volume);
    CHECK_THROWS_AS(filter.set_bound(filter.eigenvalue_bound()), core::ConfigError);
}
