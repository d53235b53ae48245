// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Blocks whose points do not match as one mesh: closed cells, one area for each sub-face, values beyond (NUMERICS B8).
#include "core/base/error.hpp"
#include "core/comm/halo.hpp"
#include "core/grid/sub_face_values.hpp"
#include "core/grid/touching_blocks.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

using core::Mesh, core::Vec3;

namespace {

/// Largest sum of area vectors of a cell over its largest face.
double open_part(const Mesh& mesh)
{
    double most = 0;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto& g = mesh.geometry(b);
        core::for_each_cell(g.cells, [&](int i, int j, int k) {
            const Vec3 sum = g.area(0, i + 1, j, k) - g.area(0, i, j, k) + g.area(1, i, j + 1, k) - g.area(1, i, j, k) +
                             g.area(2, i, j, k + 1) - g.area(2, i, j, k);
            double largest = 0;
            for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, g.area(axis, i, j, k).norm());
            most = std::max(most, sum.norm() / largest);
        });
    }
    return most;
}

double linear(const Vec3& x) { return 2 + x.x() - 0.7 * x.y() + 0.4 * x.z(); }

core::ScalarField filled(const Mesh& mesh, const std::function<double(const Vec3&)>& value)
{
    core::ScalarField field({"value", "1", 3, false}, mesh.own_cells());
    field.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.geometry(b).cells,
                            [&](int i, int j, int k) { field.on(b)(i, j, k) = value(mesh.geometry(b).centre(i, j, k)); });
    core::HaloExchange(mesh, core::Communicator::self(), 3, 3, core::HaloShape::full).fill(field);
    return field;
}

} // namespace

TEST_CASE("all cells are closed where curved blocks without matching points meet")
{
    for (const test::Halves& cells : {test::Halves{{4, 6, 8}, {4, 9, 12}}, {{4, 6, 8}, {3, 12, 8}}, {{3, 5, 6}, {5, 7, 11}}}) {
        const Mesh mesh(test::wavy_halves(cells, 0.3, 37), 0, 1);
        CHECK(mesh.topology().joints.interfaces.size() == 2);
        CHECK(mesh.topology().boundaries.empty());
        CHECK(open_part(mesh) < 1e-13); // round-off of some 100 products
    }
    for (const double curvature : {0.0, 0.02, 0.05, -0.05}) { // three sides that bend differently along the line where they meet
        const Mesh mesh(test::two_on_one(curvature), 0, 1);
        CHECK(mesh.topology().joints.interfaces.size() == 3); // left and right have points of their own too
        CHECK(open_part(mesh) < 1e-13);
    }
}

TEST_CASE("both blocks beside an interface have the same sub-faces")
{
    const Mesh mesh(test::wavy_halves({{4, 6, 8}, {4, 9, 12}}, 0.3, 0), 0, 1);
    Vec3 sum = Vec3::Zero();
    std::size_t of_a = 0, of_b = 0;
    for (core::LocalBlock b = 0; b < 2; ++b)
        for (const core::SubFaceMetrics& s : mesh.geometry(b).sub_faces) {
            sum += s.is_a ? s.area : Vec3(-s.area);
            ++(s.is_a ? of_a : of_b);
        }
    CHECK(of_a == of_b);
    CHECK(of_a > 2 * 12 * 9);
    CHECK(sum.norm() < 1e-13); // the same vectors, added in another order
}

TEST_CASE("values beyond sides without matching points are those of a linear field at the places the halo has")
{
    const Mesh mesh(test::two_on_one(0), 0, 1);
    const core::ScalarField field = filled(mesh, linear);
    double worst = 0;
    int beyond = 0;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        for (const core::HaloRow& row : core::halo_rows(mesh.topology(), b, 3, core::HaloShape::full)) {
            const Vec3 x = mesh.geometry(b).centre(row.cell.i, row.cell.j, row.cell.k);
            worst = std::max(worst, std::abs(field.on(b)[row.cell] - linear(x)));
            beyond += row.sources.size() > 1;
        }
    CHECK(beyond > 300);
    CHECK(worst < 1e-12); // weights of up to 6 that add up to 1, values of 5
}

TEST_CASE("values at sub-faces are second order across the interface, fourth along it")
{
    const auto error = [](int n, const std::function<double(const Vec3&)>& value) {
        const Mesh mesh(test::wavy_halves({{2 * n, 2 * n, 2 * n}, {2 * n, 3 * n, 3 * n}}, 0, 0), 0, 1);
        const core::ScalarField field = filled(mesh, value);
        double worst = 0;
        for (core::LocalBlock b = 0; b < 2; ++b)
            for (const core::BlockSubFace& s : core::sub_face_values(mesh.topology(), b).faces) {
                const core::SidePlace& at = s.face->on_a;
                const double h = 2 * std::numbers::pi / mesh.cells(at.block).nj;
                const double x = at.side == core::Side::i_high ? std::numbers::pi : 0;
                worst = std::max(worst, std::abs(field.on(b).behind_halo(s.at_centre) - value({x, at.p * h, at.q * h})));
            }
        return worst;
    };
    const auto along = [](const Vec3& x) { return std::sin(x.y()) * std::cos(x.z()); };
    const auto across = [](const Vec3& x) { return std::cos(x.x()); };
    CHECK(std::log2(error(6, along) / error(12, along)) > 3.8);
    CHECK(std::log2(error(6, across) / error(12, across)) > 1.9);
}

TEST_CASE("a side that others cover in part only is refused by name")
{
    const core::Box below{{0, 0, 0}, {2, 1, 1}, {8, 3, 4}, {1, 1, 1}, {}}, above{{0, 1, 0}, {1, 2, 1}, {5, 3, 3}, {1, 1, 1}, {}};
    CHECK_THROWS_WITH_AS(Mesh(test::joined({below, above}, {}, [](const Vec3& x) { return x; }), 0, 1),
                         "side j_high of block 0 lies on others over 0 % of its face (4, 0) only: let it end where they end",
                         core::ConfigError);
}

TEST_CASE("blocks are cut where others end on their sides, and with them those that match them")
{
    // Beside a stack of two blocks stands one that is half as high again as the lower of them; its neighbour above matches it.
    const core::Box lower{{0, 0, 0}, {1, 1, 1}, {3, 4, 2}, {1, 1, 1}, {}}, upper{{0, 1, 0}, {1, 2, 1}, {3, 5, 3}, {1, 1, 1}, {}},
        beside{{1, 0, 0}, {2, 1.5, 1}, {4, 6, 5}, {1, 1, 1}, {}}, behind{{2, 0, 0}, {3, 1.5, 1}, {2, 6, 5}, {1, 1, 1}, {}};
    core::MultiBlock grid;
    for (const core::Box& box : {lower, upper, beside, behind}) grid.blocks.push_back(core::make_box(box).blocks.front());
    grid.boundary_name = [](core::BlockId block, core::Side) { return "of block " + std::to_string(block); };
    CHECK_THROWS_AS(core::join_touching_blocks(grid), core::ConfigError); // the upper block has no line at y = 1.5
    core::Box even = upper;
    even.cells.nj = 4;
    grid.blocks[1] = core::make_box(even).blocks.front();
    const auto covered = core::join_touching_blocks(grid);
    const auto of = [&](core::BlockId block, core::Side side) {
        return std::find_if(covered.begin(), covered.end(), [&](const core::CoveredSide& c) { return c.block == block && c.side == side; });
    };
    REQUIRE(of(1, core::Side::i_high) != covered.end());
    CHECK(of(0, core::Side::i_high)->wholly);
    CHECK_FALSE(of(1, core::Side::i_high)->wholly);
    const Mesh mesh(std::move(grid), 0, 1);
    CHECK(mesh.blocks() == 5); // the upper block in two
    CHECK(mesh.total_volume() == doctest::Approx(5));
    CHECK(open_part(mesh) < 1e-13);
    const auto& boundaries = mesh.topology().boundaries;
    CHECK(std::any_of(boundaries.begin(), boundaries.end(),
                      [](const core::Boundary& b) { return b.block == 2 && b.side == core::Side::i_high && b.name == "of block 1"; }));
}
