// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include "physics/fluid/flow_shape.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <doctest/doctest.h>

namespace {

using core::Vec3;

bool any_wall(const std::string&) { return true; }

} // namespace

TEST_CASE("laminar shape between plates is the parabola, and half of it below a plane that is no wall")
{
    for (const int cells : {4, 5}) {
        const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 2, 1}, {2, cells, 2}, {1, 1, 1}, {false, false, true}}), 0, 1);
        const auto full = physics::laminar_shape(mesh, "x_low", any_wall);
        const auto half = physics::laminar_shape(mesh, "x_low", [](const std::string& name) { return name != "y_high"; });
        const double h = 2.0 / cells;
        // The mean over faces of 3/2 (1 - y^2) by the midpoint rule is 1 + h^2 / 8 of the half height, of the other a quarter of that.
        const double full_scale = 1.5 / (1 + h * h / 8), half_scale = 1.5 / (1 + h * h / 32);
        for (const double y : {0.1, 0.5, 1.0, 1.7}) {
            CHECK(full({0, y, 0.3}) == test::relative(full_scale * y * (2 - y)).epsilon(1e-12));
            CHECK(half({0, y, 0.3}) == test::relative(half_scale * (1 - (1 - y / 2) * (1 - y / 2))).epsilon(1e-12));
        }
    }
}

TEST_CASE("laminar shape in a round pipe is the paraboloid, to second order")
{
    const auto error = [](int across) {
        core::Pipe pipe;
        pipe.diameter = 2;
        pipe.length = 1;
        pipe.core_cells = across / 2;
        pipe.wing_cells = across / 4;
        pipe.axial_cells = 1;
        pipe.blocks_along = 1;
        pipe.periodic = false;
        const core::Mesh mesh(core::make_pipe(pipe), 0, 1);
        const auto shape = physics::laminar_shape(mesh, "x_low", [](const std::string& name) { return name == "wall"; });
        double worst = 0;
        for (const double r : {0.05, 0.3, 0.6, 0.9})
            for (const double angle : {0.1, 1.3, 2.9})
                worst = std::max(worst, std::abs(shape({0, r * std::cos(angle), r * std::sin(angle)}) - 2 * (1 - r * r)));
        return worst;
    };
    CHECK(std::log2(error(16) / error(32)) > 1.8);
    CHECK(error(32) < 0.02);
}

TEST_CASE("laminar flow without a wall beside it is refused")
{
    const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {false, true, true}}), 0, 1);
    CHECK_THROWS_AS((void)physics::laminar_shape(mesh, "x_low", any_wall), core::ConfigError);
}

TEST_CASE("velocities between scattered points are exact where they are linear, second order elsewhere, and those of the points")
{
    const auto points = [](int n, const std::function<Vec3(const Vec3&)>& velocity) {
        std::vector<physics::VelocityPoint> all;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                // Off a lattice by a third of its spacing.
                const Vec3 x(0.7, (i + 0.3 * std::sin(7.0 * i + 3.0 * j)) / n, (j + 0.3 * std::cos(5.0 * i - 2.0 * j)) / n);
                all.push_back({x, velocity(x)});
            }
        return all;
    };
    const auto linear = [](const Vec3& x) { return Vec3(1 + 2 * x.y() - x.z(), x.z(), 0.5); };
    const auto curved = [](const Vec3& x) { return Vec3(std::sin(3 * x.y()) * std::cos(2 * x.z()), 0, 0); };
    const auto of_linear = physics::interpolated_velocity(points(6, linear));
    const auto error = [&](int n) {
        const auto between = physics::interpolated_velocity(points(n, curved));
        double worst = 0;
        for (double y = 0.2; y < 0.8; y += 0.037)
            for (double z = 0.2; z < 0.8; z += 0.041) worst = std::max(worst, (between({0.7, y, z}) - curved({0.7, y, z})).norm());
        return worst;
    };
    CHECK((of_linear({0.7, 0.31, 0.77}) - linear({0.7, 0.31, 0.77})).norm() < 1e-13);
    CHECK(std::log2(error(10) / error(40)) / 2 > 1.7);
    const auto given = points(6, curved);
    CHECK((physics::interpolated_velocity(given)(given[17].place) - given[17].velocity).norm() == 0);
}
