// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Elliptic grids against exact solutions of the Poisson system (NUMERICS C0 U1, U2), and what users ask of them.
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/elliptic_grid.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"
#include "core/grid/pipe.hpp"
#include "core/grid/stepped_channel.hpp"
#include "core/grid/transfinite.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Curvature, core::Extents, core::Vec3, core::Vertices;

namespace {

constexpr double pi = std::numbers::pi;

/// A block whose vertices are a map of the unit cube.
template <class Map>
Vertices mapped(Extents cells, Map map)
{
    core::Box box;
    box.cells = cells;
    return core::make_box(box, map).blocks.front();
}

double largest_distance(const Vertices& a, const Vertices& b)
{
    double largest = 0;
    for (std::size_t n = 0; n < a.data().size(); ++n) largest = std::max(largest, (a.data()[n] - b.data()[n]).norm());
    return largest;
}

double smallest_jacobian(const Vertices& v)
{
    double smallest = 1;
    core::for_each_cell(core::cells_of(v), [&](int i, int j, int k) {
        smallest = std::min(smallest, core::smallest_corner_jacobian(v, {i, j, k}));
    });
    return smallest;
}

/// Error of the generator against a map that solves the system, from a transfinite start.
double error_of(const Vertices& exact, core::Elliptic wanted)
{
    Vertices grid = exact;
    core::fill_transfinite(grid);
    wanted.tolerance = 1e-10;
    const auto result = core::make_elliptic(grid, wanted);
    CHECK(result.move < 1e-10);
    CHECK(result.control_share == 1);
    return largest_distance(grid, exact);
}

double annulus_error(int n, Curvature kind)
{
    // ln r and the angle are harmonic: equal steps of both are the solution without control.
    const auto polar = mapped({3, n, n}, [](const Vec3& s) {
        const double r = std::pow(2.0, s.y()), angle = pi / 2 * s.z();
        return Vec3(s.x(), r * std::cos(angle), r * std::sin(angle));
    });
    core::Elliptic wanted;
    wanted.curvature = kind;
    return error_of(polar, wanted);
}

double stretching_error(int n, Curvature kind)
{
    // x = (exp(a s) - 1) / (exp(a) - 1) has div grad s = -((exp(a) - 1)^2 / a) exp(-2 a s), n times as much for the index.
    const double a = 2, e = std::exp(a) - 1;
    const auto stretched = mapped({n, 4, 4}, [&](const Vec3& s) { return Vec3((std::exp(a * s.x()) - 1) / e, s.y(), s.z()); });
    core::Elliptic wanted;
    wanted.curvature = kind;
    wanted.control = core::no_control(stretched.extents());
    core::for_each_cell(stretched.extents(),
                        [&](int i, int j, int k) { wanted.control.source[0](i, j, k) = -n * e * e / a * std::exp(-2 * a * i / n); });
    return error_of(stretched, wanted);
}

/// A duct in z over a hump, between side walls that bulge: without folds at its corners.
Vertices humped(Extents cells, double hump, double bulge)
{
    auto block = mapped(cells, [&](const Vec3& s) {
        const double below = hump * std::pow(std::sin(pi * s.x()), 2), left = bulge * std::pow(std::sin(pi * s.y()), 2);
        const bool on_side = s.x() == 0 || s.x() == 1;
        return on_side ? Vec3(s.x() + left, s.y(), s.z()) : Vec3(s.x(), s.y() == 0 ? below : s.y(), s.z());
    });
    // The z sides are plane: their own interiors are transfinite in (x, y).
    for (const int k : {0, cells.nk})
        core::for_each({1, 1, k}, {cells.ni, cells.nj, k + 1}, [&](int i, int j, int kk) {
            const double s = double(i) / cells.ni, t = double(j) / cells.nj;
            const auto at = [&](int p, int q) { return block(p, q, kk); };
            block(i, j, kk) = (1 - s) * at(0, j) + s * at(cells.ni, j) + (1 - t) * at(i, 0) + t * at(i, cells.nj) -
                              (1 - s) * (1 - t) * at(0, 0) - s * (1 - t) * at(cells.ni, 0) - (1 - s) * t * at(0, cells.nj) -
                              s * t * at(cells.ni, cells.nj);
        });
    core::fill_transfinite(block);
    return block;
}

} // namespace

TEST_CASE("without control an annulus gets its conformal grid: second order with spline curvatures, fourth with compact ones")
{
    const double coarse = annulus_error(8, Curvature::cubic_spline), fine = annulus_error(16, Curvature::cubic_spline);
    CHECK(std::log2(coarse / fine) > 1.9);
    const double coarse4 = annulus_error(8, Curvature::compact), fine4 = annulus_error(16, Curvature::compact);
    CHECK(std::log2(coarse4 / fine4) > 3.5); // its ends are of lower order and still weigh on 8 cells
    MESSAGE("annulus: " << coarse << " " << fine << ", compact " << coarse4 << " " << fine4);
    CHECK(fine4 < 1e-5);
}

TEST_CASE("the sources of an exponential stretching give it: second order with spline curvatures, fourth with compact ones")
{
    const double coarse = stretching_error(12, Curvature::cubic_spline), fine = stretching_error(24, Curvature::cubic_spline);
    CHECK(std::log2(coarse / fine) > 1.9);
    const double coarse4 = stretching_error(12, Curvature::compact), fine4 = stretching_error(24, Curvature::compact);
    CHECK(std::log2(coarse4 / fine4) > 3.5);
    MESSAGE("stretching: " << coarse << " " << fine << ", compact " << coarse4 << " " << fine4);
}

TEST_CASE("a bent duct that transfinite interpolation folds comes out whole")
{
    Vertices block = humped({24, 24, 3}, 0.45, 0.3);
    CHECK(smallest_jacobian(block) < 0);
    for (const auto side : {core::Side::k_low, core::Side::k_high}) core::make_elliptic_side(block, side, {});
    const auto result = core::make_elliptic(block, {});
    // Between two equal plane sides every layer is the same, to what iterations leave that stop at moves of 1e-6 edges.
    for (int j = 0; j <= 24; ++j) CHECK((block(8, j, 1) - block(8, j, 0) - Vec3(0, 0, 1.0 / 3)).norm() < 1e-5);
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_elliptic_side(block, core::Side::j_low, {})),
                         doctest::Contains("side j_low is not plane"), core::ConfigError);
    MESSAGE("smallest Jacobian " << smallest_jacobian(block) << " after " << result.iterations << " iterations");
    CHECK(smallest_jacobian(block) > 0.05);
}

TEST_CASE("the first cells at curved walls have the height that was asked for, within 2 %")
{
    Vertices block = humped({12, 24, 4}, 0.3, 0);
    core::Elliptic wanted;
    wanted.spacings = {{core::Side::j_low, 0.004, 1.4}, {core::Side::j_high, 0.01, 1.4}};
    const auto result = core::make_elliptic(block, wanted);
    MESSAGE("spacing error " << result.spacing_error << " after " << result.iterations << " iterations, move " << result.move);
    CHECK(result.control_share == 1);
    double worst = 0;
    core::for_each({1, 0, 1}, {12, 1, 4}, [&](int i, int, int k) {
        for (const bool high : {false, true}) {
            const int foot = high ? 24 : 0, next = high ? 23 : 1;
            const Vec3 normal =
                (block(i + 1, foot, k) - block(i - 1, foot, k)).cross(block(i, foot, k + 1) - block(i, foot, k - 1)).normalized();
            const double height = std::abs(normal.dot(block(i, next, k) - block(i, foot, k)));
            worst = std::max(worst, std::abs(height / (high ? 0.01 : 0.004) - 1));
        }
    });
    CHECK(worst < 0.02);
    wanted.spacings[0].growth = wanted.spacings[1].growth = 1.05;
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_elliptic(block, wanted)), doctest::Contains("let them grow faster"),
                         core::ConfigError);
}

TEST_CASE("lines come to a surface, a line or a point that attracts them")
{
    const auto distance = [](std::array<std::optional<double>, 3> at) {
        Vertices block = mapped({8, 8, 8}, [](const Vec3& s) { return s; });
        core::Elliptic wanted;
        wanted.attractions = {{at, 0.3, 3}};
        core::make_elliptic(block, wanted);
        CHECK(smallest_jacobian(block) > 0.5);
        return Vec3((block(5, 4, 4) - block(4, 4, 4)).x(), (block(4, 5, 4) - block(4, 4, 4)).y(), (block(4, 4, 5) - block(4, 4, 4)).z());
    };
    const Vec3 surface = distance({4.0, std::nullopt, std::nullopt}), line = distance({4.0, 4.0, std::nullopt}),
               point = distance({4.0, 4.0, 4.0});
    CHECK(surface.x() < 0.9 / 8);
    CHECK(surface.y() == test::relative(0.125).epsilon(1e-6));
    CHECK(line.x() < 0.95 / 8);
    CHECK(line.y() == test::relative(line.x()).epsilon(1e-6));
    CHECK(line.z() == test::relative(0.125).epsilon(1e-6));
    CHECK(point.maxCoeff() < 0.98 / 8);
    CHECK(surface.x() < line.x());
    CHECK(line.x() < point.x());
}

TEST_CASE("the grid does not depend on how the block counts")
{
    Vertices block = humped({10, 8, 4}, 0.3, 0.1);
    Vertices other({block.extents().nk, block.extents().ni, block.extents().nj}, 0, Vec3::Zero());
    const auto there = [&](int i, int j, int k) -> Vec3& { return other(block.extents().nk - 1 - k, block.extents().ni - 1 - i, j); };
    core::for_each_cell(block.extents(), [&](int i, int j, int k) { there(i, j, k) = block(i, j, k); });
    core::Elliptic wanted, wanted_there;
    wanted.tolerance = wanted_there.tolerance = 1e-12;
    wanted.attractions = {{{std::nullopt, 2.0, std::nullopt}, 0.2, 3}};
    wanted_there.attractions = {{{std::nullopt, std::nullopt, 2.0}, 0.2, 3}};
    core::make_elliptic(block, wanted);
    core::make_elliptic(other, wanted_there);
    double largest = 0;
    core::for_each_cell(block.extents(),
                        [&](int i, int j, int k) { largest = std::max(largest, (there(i, j, k) - block(i, j, k)).norm()); });
    CHECK(largest < 1e-10); // both rest within 1e-12 of an edge per iteration, and halve the distance each time
}

TEST_CASE("a spacing at the wall of a pipe reaches all its blocks, and they still meet")
{
    core::Pipe pipe;
    pipe.core_cells = 6;
    pipe.wing_cells = 8;
    pipe.axial_cells = 6;
    pipe.blocks_along = 2;
    core::MultiBlock grid = core::make_pipe(pipe);
    core::EllipticGrid wanted;
    wanted.spacings = {{"wall", 0.5e-3, 1.4}};
    const auto results = core::make_elliptic(grid, wanted);
    for (const auto& result : results) CHECK(result.control_share == 1);
    for (const auto& result : results) CHECK(result.spacing_error < 0.01);
    const core::Mesh mesh(grid, 0, 1);
    CHECK(mesh.topology().interfaces.size() == 13 * 2);
    for (const core::BlockId b : {1, 4, 9})
        CHECK((mesh.vertices(b)(3, 1, 8) - mesh.vertices(b)(3, 1, 7)).norm() == test::relative(0.5e-3).epsilon(0.01));
    wanted.spacings = {{"floor", 1e-3, 1.2}};
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_elliptic(grid, wanted)),
                         doctest::Contains("no boundary of the grid is called 'floor'"), core::ConfigError);
}

TEST_CASE("the step of a channel hands its spacing on to the open water above it")
{
    core::SteppedChannel channel;
    core::MultiBlock grid = core::make_stepped_channel(channel);
    core::EllipticGrid wanted;
    wanted.spacings = {{"step", 2e-3, 1.3}, {"y_low", 2e-3, 1.4}};
    core::make_elliptic(grid, wanted);
    const core::Mesh mesh(grid, 0, 1);
    CHECK(mesh.topology().interfaces.size() == 2);
    const auto &below = mesh.vertices(1), &above = mesh.vertices(2), &shallow = mesh.vertices(0);
    CHECK((below(1, 4, 4) - below(0, 4, 4)).norm() == test::relative(2e-3).epsilon(0.01));
    CHECK((above(1, 4, 4) - above(0, 4, 4)).norm() == test::relative(2e-3).epsilon(0.01));
    CHECK((below(12, 1, 4) - below(12, 0, 4)).norm() == test::relative(2e-3).epsilon(0.01));
    CHECK((shallow(4, 1, 4) - shallow(4, 0, 4)).norm() == test::relative(2e-3).epsilon(0.01));
    CHECK((above(12, 1, 4) - above(12, 0, 4)).norm() == test::relative(2e-3).epsilon(0.01)); // it goes on from the shallow floor
}
