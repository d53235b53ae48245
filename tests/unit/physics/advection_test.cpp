// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What advection is made of: the spline's weights, and the range that advected vectors keep.
#include "core/base/random.hpp"
#include "core/grid/box.hpp"
#include "core/grid/mesh.hpp"
#include "physics/fluid/hermite.hpp"
#include "physics/fluid/quasi_monotone.hpp"
#include "tests/support/relative.hpp"
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <complex>
#include <doctest/doctest.h>
#include <numbers>

namespace {

using core::Vec3;

/// Value at the offset s from the third of six points of the cubic spline without curvature at its ends, by solving for its curvatures.
double spline_value(const std::array<double, 6>& f, double s)
{
    Eigen::Matrix<double, 6, 6> system = Eigen::Matrix<double, 6, 6>::Identity();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (int n = 1; n < 5; ++n) {
        system.row(n) << 0, 0, 0, 0, 0, 0;
        system.block<1, 3>(n, n - 1) << 1.0 / 6, 2.0 / 3, 1.0 / 6;
        right[n] = f[std::size_t(n - 1)] - 2 * f[std::size_t(n)] + f[std::size_t(n + 1)];
    }
    const Eigen::Matrix<double, 6, 1> m = system.fullPivLu().solve(right);
    const double u = 1 - s;
    return u * f[2] + s * f[3] + (u * u * u - u) / 6 * m[2] + (s * s * s - s) / 6 * m[3];
}

/// Three components of cells of a block, with one halo layer.
struct Vectors {
    core::Array3<double> x, y, z;
    explicit Vectors(core::Extents n) : x(n, 1), y(n, 1), z(n, 1) {}
    [[nodiscard]] core::VectorView<double> view() { return {x.view(), y.view(), z.view()}; }
    [[nodiscard]] Vec3 at(int i, int j, int k) const { return {x(i, j, k), y(i, j, k), z(i, j, k)}; }
    void set(int i, int j, int k, const Vec3& v) { x(i, j, k) = v.x(), y(i, j, k) = v.y(), z(i, j, k) = v.z(); }
};

constexpr core::Extents cells{5, 4, 3};

template <class Body>
void each_with_halo(Body body)
{
    core::for_each({-1, -1, -1}, {cells.ni + 1, cells.nj + 1, cells.nk + 1}, body);
}

/// A box of skewed cells.
core::Mesh skewed_box(const core::Mat3& turn)
{
    const auto map = [&](const Vec3& x) { return Vec3(turn * (x + 0.2 * Vec3(std::sin(x.y()), std::sin(x.z()), std::sin(x.x())))); };
    return core::Mesh(core::make_box({{0, 0, 0}, {4, 4, 3}, cells, {1, 1, 1}, {}}, map), 0, 1);
}

/// Values, displacements and advected values that know nothing of each other, all between -1 and 1.
struct Case {
    core::Mesh mesh;
    Vectors q{cells}, displacement{cells}, advected{cells};
    explicit Case(const core::Mat3& turn = core::Mat3::Identity()) : mesh(skewed_box(turn))
    {
        std::uint64_t drawn = 0;
        each_with_halo([&](int i, int j, int k) {
            for (Vectors* v : {&q, &displacement, &advected}) {
                const auto [x, y, z, unused] = core::random_uniform(7, 0, drawn++);
                v->set(i, j, k, 2 * Vec3(x, y, z) - Vec3::Ones());
            }
        });
    }
    void keep() { physics::keep_in_range(mesh.geometry(0), q.view(), displacement.view(), advected.view()); }
    /// Components in the index space of a cell.
    [[nodiscard]] Vec3 in_index_space(int i, int j, int k, const Vec3& v) const
    {
        Vec3 components = Vec3::Zero();
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t n = 0; n < 3; ++n) components[int(m)] += mesh.geometry(0).inverse_jacobian[m][n](i, j, k) * v[int(n)];
        return components;
    }
    /// The eight cells around a departure point.
    [[nodiscard]] std::vector<Vec3> around(int i, int j, int k) const
    {
        const Vec3 d = displacement.at(i, j, k);
        const auto from = [](double way) { return way > 0 ? -1 : 1; };
        std::vector<Vec3> eight;
        for (const int a : {0, from(d.x())})
            for (const int b : {0, from(d.y())})
                for (const int c : {0, from(d.z())}) eight.push_back(q.at(i + a, j + b, k + c));
        return eight;
    }
};

} // namespace

TEST_CASE("spline weights are those of the natural spline through six points")
{
    const std::array<double, 6> f{0.3, -1.2, 0.7, 2.5, -0.4, 0.9};
    for (const double s : {0.0, 0.25, 0.6, 1.0}) {
        std::array<double, 7> w;
        physics::spline_weights(s, w.data(), 1);
        double up = 0;
        for (std::size_t n = 0; n < 6; ++n) up += w[n + 1] * f[n];
        CHECK(std::abs(up - spline_value(f, s)) < 1e-14); // round-off of numbers of size one
        if (s == 0) continue;
        physics::spline_weights(-s, w.data(), 1);
        double down = 0;
        for (std::size_t n = 0; n < 6; ++n) down += w[5 - n] * f[n];
        CHECK(std::abs(down - up) < 1e-14);
    }
}

TEST_CASE("the literal local spline amplifies a mode by a third of a percent at each use")
{
    double largest = 0;
    for (double s = 0; s <= 1; s += 0.01)
        for (double angle = 0; angle <= std::numbers::pi; angle += 0.01) {
            std::array<double, 7> w;
            physics::spline_weights(s, w.data(), 1);
            std::complex<double> gain = 0;
            for (int p = 0; p < 7; ++p) gain += w[std::size_t(p)] * std::polar(1.0, angle * (p - 3));
            largest = std::max(largest, std::abs(gain));
        }
    CHECK(largest == test::relative(1.0033).epsilon(1e-4)); // NUMERICS A5
}

TEST_CASE("advected vectors that differ in one direction are clipped between the least and the most of the eight cells")
{
    Case one;
    const Vec3 direction = Vec3(1, -2, 0.5).normalized(), base(3, 1, -2);
    each_with_halo([&](int i, int j, int k) {
        one.q.set(i, j, k, base + one.q.x(i, j, k) * direction);
        one.advected.set(i, j, k, base + 2 * one.advected.x(i, j, k) * direction);
    });
    const Vectors before = one.advected;
    one.keep();
    int clipped = 0;
    core::for_each_cell(cells, [&](int i, int j, int k) {
        double least = 1e9, most = -1e9;
        for (const Vec3& u : one.around(i, j, k)) {
            least = std::min(least, (u - base).dot(direction));
            most = std::max(most, (u - base).dot(direction));
        }
        const double wanted = (before.at(i, j, k) - base).dot(direction);
        CHECK((one.advected.at(i, j, k) - base - std::clamp(wanted, least, most) * direction).norm() <
              1e-13); // round-off of numbers of size one
        clipped += wanted < least || wanted > most;
    });
    CHECK(clipped > 10);
}

TEST_CASE("components in index space are clipped between the least and the most of the eight cells around the departure point")
{
    Case one;
    const Vectors before = one.advected;
    one.keep();
    core::for_each_cell(cells, [&](int i, int j, int k) {
        Vec3 least = Vec3::Constant(1e9), most = -least;
        for (const Vec3& u : one.around(i, j, k)) {
            const Vec3 components = one.in_index_space(i, j, k, u);
            least = least.cwiseMin(components);
            most = most.cwiseMax(components);
        }
        const Vec3 wanted = one.in_index_space(i, j, k, before.at(i, j, k)), kept = one.in_index_space(i, j, k, one.advected.at(i, j, k));
        CHECK((kept - wanted.cwiseMax(least).cwiseMin(most)).norm() < 1e-13); // round-off of numbers of size one
    });
}

TEST_CASE("the range of advected vectors turns with them")
{
    const core::Mat3 turn = Eigen::AngleAxisd(0.65, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    Case straight, turned(turn);
    each_with_halo([&](int i, int j, int k) {
        turned.q.set(i, j, k, turn * straight.q.at(i, j, k));
        turned.advected.set(i, j, k, turn * straight.advected.at(i, j, k));
    });
    straight.keep();
    turned.keep();
    core::for_each_cell(cells, [&](int i, int j, int k) {
        CHECK((turned.advected.at(i, j, k) - turn * straight.advected.at(i, j, k)).norm() < 1e-13); // round-off of numbers of size one
    });
}
