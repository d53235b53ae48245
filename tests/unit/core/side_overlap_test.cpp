// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Sides that meet without matching points: sub-faces, their sums, and the closure of every cell (NUMERICS B8, D 26).
#include "core/base/random.hpp"
#include "core/grid/box.hpp"
#include "core/grid/side_overlap.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <functional>
#include <numbers>

using core::Array3, core::FaceIndex, core::Side, core::SideOverlap, core::SideTiling, core::Vec3, core::Vertices;

namespace {

constexpr double round_off = 1e-13; // of a face, after sums of some 100 products

using Surface = std::function<double(double, double)>;

double flat(double, double) { return 0; }
double wavy(double x, double y) { return 0.1 * std::sin(3 * x) * std::cos(2 * y); }
double barrel(double x, double) { return std::sqrt(4 - (x - 0.5) * (x - 0.5)) - 2; }

struct Layer {
    core::Extents cells;
    double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
    double bottom = 0, top = 1; ///< of these two, the one that is 0 lies on the surface
    double stretch = 0;         ///< of the points along x, without moving the ends
};

/// A layer of cells above or below a surface.
Vertices layer(const Layer& l, const Surface& surface, const core::Mat3& turn = core::Mat3::Identity())
{
    core::Box box;
    box.cells = l.cells;
    return core::make_box(box,
                          [&](const Vec3& s) {
                              const double share = s.x() + l.stretch * s.x() * (1 - s.x());
                              const double x = l.x_low + share * (l.x_high - l.x_low), y = l.y_low + s.y() * (l.y_high - l.y_low);
                              const double z = l.bottom + s.z() * (l.top - l.bottom);
                              return Vec3(turn * Vec3(x, y, z + (1 - std::abs(z)) * surface(x, y)));
                          })
        .blocks.front();
}

/// Moves the inner points of the bottom side by up to a fifth of a cell within the plane z = 0.
void shake(Vertices& v)
{
    const double x = 0.2 / core::cells_of(v).ni, y = 0.2 / core::cells_of(v).nj;
    for (int j = 1; j + 1 < v.extents().nj; ++j)
        for (int i = 1; i + 1 < v.extents().ni; ++i) {
            const auto u = core::random_uniform(7, i, std::uint64_t(j));
            v(i, j, 0) += Vec3(x * (2 * u[0] - 1), y * (2 * u[1] - 1), 0);
        }
}

Array3<Vec3> sums(const SideTiling& tiling, const std::vector<const SideOverlap*>& overlaps, bool of_master)
{
    Array3<Vec3> sum({tiling.np(), tiling.nq(), 1}, 0, Vec3::Zero());
    for (const SideOverlap* overlap : overlaps)
        for (const core::SubFace& f : overlap->faces) {
            const FaceIndex n = of_master ? f.master : f.other;
            sum(n.p, n.q, 0) += (of_master || overlap->same_sense ? 1 : -1) * f.area;
        }
    return sum;
}

/// Largest |sum of area vectors| of the cells of a block on its side k_low, in parts of a face, when the side consists of
/// sub-faces and its edges bend.
double open_part(const Vertices& block, const SideTiling& tiling, const std::vector<const SideOverlap*>& overlaps)
{
    const auto sub = sums(tiling, overlaps, false);
    const core::EdgeSlivers slivers = core::edge_slivers(tiling, overlaps);
    const auto i_face = [&](int p, int q) {
        return Vec3(core::face_shape(core::face_corners(block, 0, {p, q, 0})).area + slivers[1](p, q, 0));
    };
    const auto j_face = [&](int p, int q) {
        return Vec3(core::face_shape(core::face_corners(block, 1, {p, q, 0})).area - slivers[0](p, q, 0));
    };
    double largest = 0;
    for (int q = 0; q < tiling.nq(); ++q)
        for (int p = 0; p < tiling.np(); ++p) {
            const Vec3 top = core::face_shape(core::face_corners(block, 2, {p, q, 1})).area;
            const Vec3 sum = top - sub(p, q, 0) + i_face(p + 1, q) - i_face(p, q) + j_face(p, q + 1) - j_face(p, q);
            largest = std::max(largest, sum.norm() / top.norm());
        }
    return largest;
}

/// The faces of the master are exactly the sums of their sub-faces.
double open_part_of_master(const SideTiling& master, const SideOverlap& overlap)
{
    const auto sub = sums(master, {&overlap}, true);
    double largest = 0;
    for (int q = 0; q < master.nq(); ++q)
        for (int p = 0; p < master.np(); ++p)
            largest = std::max(largest, (sub(p, q, 0) - master.area(p, q)).norm() / master.area(p, q).norm());
    return largest;
}

double total(const SideOverlap& overlap)
{
    double sum = 0;
    for (const auto& f : overlap.faces) sum += f.area.norm();
    return sum;
}

double smallest_share(const SideTiling& a, const SideTiling& b, const SideOverlap& overlap)
{
    double smallest = 1;
    for (const auto& f : overlap.faces)
        smallest = std::min(smallest, f.area.norm() / std::min(a.area(f.master.p, f.master.q).norm(), b.area(f.other.p, f.other.q).norm()));
    return smallest;
}

void check_pair(const Vertices& below, const Vertices& above)
{
    const SideTiling a(below, Side::k_high), b(above, Side::k_low);
    const SideOverlap overlap = core::overlap(a, b);
    CHECK(open_part_of_master(a, overlap) < round_off);
    CHECK(open_part(above, b, {&overlap}) < round_off);
    CHECK(smallest_share(a, b, overlap) > 1e-8);
}

} // namespace

TEST_CASE("cells close at any ratio of their numbers, on flat, curved and turned sides")
{
    const core::Mat3 turn = Eigen::AngleAxisd(37 * std::numbers::pi / 180, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (const Surface& surface : {Surface(flat), Surface(wavy), Surface(barrel)})
        for (const auto& [n, m] : {std::pair{6, 6}, {6, 9}, {9, 6}, {4, 8}, {8, 4}, {3, 12}, {12, 3}, {2, 16}, {16, 2}, {100, 101}})
            for (const core::Mat3& t : {core::Mat3(core::Mat3::Identity()), turn}) {
                const int across = n == 100 ? 2 : 5;
                check_pair(layer({{n, across, 1}, 0, 1, 0, 1, -1, 0}, surface, t), layer({{m, n == 100 ? 3 : m, 1}}, surface, t));
            }
}

TEST_CASE("points that nearly match leave no slivers below 1e-8 of a face, and cells close")
{
    for (const double shift : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
        for (const Surface& surface : {Surface(flat), Surface(wavy)})
            check_pair(layer({{8, 8, 1}, 0, 1, 0, 1, -1, 0}, surface), layer({{8, 8, 1}, 0, 1, 0, 1, 0, 1, shift}, surface));
}

TEST_CASE("cells close when the points of both sides are shaken by a fifth of a cell")
{
    Vertices below = layer({{7, 6, 1}, 0, 1, 0, 1, -1, 0}, flat), above = layer({{5, 9, 1}}, flat);
    shake(above);
    check_pair(below, above);
}

TEST_CASE("the sub-faces of flat sides have the area of both, those of curved sides that of the surface to second order")
{
    const auto area = [](const Surface& surface, int n, int m) {
        return total(
            core::overlap({layer({{n, n, 1}, 0, 1, 0, 1, -1, 0}, surface), Side::k_high}, {layer({{m, m, 1}}, surface), Side::k_low}));
    };
    CHECK(area(flat, 5, 7) == test::relative(1).epsilon(1e-13));
    const double exact = 4 * std::asin(0.25); // a strip of a cylinder of radius 2
    const double coarse = std::abs(area(barrel, 4, 6) - exact), fine = std::abs(area(barrel, 8, 12) - exact);
    CHECK(std::log2(coarse / fine) > 1.9);
}

TEST_CASE("sides that meet in part share just that part")
{
    const SideTiling a(layer({{10, 4, 1}, 0, 1, 0, 1, -1, 0}, flat), Side::k_high);
    const auto above = layer({{7, 3, 1}, 0.33, 0.81, 0.25, 1, 0, 1}, flat);
    const SideTiling b(above, Side::k_low);
    const SideOverlap overlap = core::overlap(a, b);
    CHECK(total(overlap) == test::relative(0.48 * 0.75).epsilon(1e-13));
    CHECK(open_part(above, b, {&overlap}) < round_off);
    const auto covered = sums(a, {&overlap}, true);
    CHECK(covered(3, 2, 0).z() == test::relative(0.07 * 0.25).epsilon(1e-13)); // from x = 0.33 to 0.4
    CHECK(covered(2, 2, 0).norm() == 0);
    CHECK(covered(5, 0, 0).norm() == 0);
    const SideTiling beside(layer({{4, 4, 1}, 1, 2, 0, 1, 0, 1}, flat), Side::k_low), far(layer({{4, 4, 1}}, flat), Side::k_high);
    CHECK(core::overlap(a, beside).faces.empty());
    CHECK(core::overlap(a, far).faces.empty());
}

TEST_CASE("a side that meets two others closes along the line where these touch")
{
    for (const Surface& surface : {Surface(flat), Surface(wavy), Surface(barrel)}) {
        const SideTiling left(layer({{4, 5, 1}, 0, 0.45, 0, 1, -1, 0}, surface), Side::k_high);
        const SideTiling right(layer({{7, 5, 1}, 0.45, 1, 0, 1, -1, 0}, surface), Side::k_high);
        const auto above = layer({{6, 8, 1}}, surface);
        const SideTiling b(above, Side::k_low);
        const SideOverlap one = core::overlap(left, b), two = core::overlap(right, b);
        CHECK(open_part_of_master(left, one) < round_off);
        CHECK(open_part_of_master(right, two) < round_off);
        CHECK(open_part(above, b, {&one, &two}) < round_off);
    }
}

TEST_CASE("the sub-faces do not depend on how the other side counts")
{
    const SideTiling a(layer({{6, 5, 1}, 0, 1, 0, 1, -1, 0}, wavy), Side::k_high);
    const auto above = layer({{4, 7, 1}}, wavy);
    Vertices turned({2, 8, 5}, 0, Vec3::Zero()); // k, j from the end, i
    core::for_each_cell(above.extents(), [&](int i, int j, int k) { turned(k, 7 - j, i) = above(i, j, k); });
    const SideOverlap first = core::overlap(a, SideTiling(above, Side::k_low)), second = core::overlap(a, SideTiling(turned, Side::i_low));
    CHECK(first.same_sense);
    CHECK(second.same_sense); // its faces run along -y and x: the same sense as x and y
    REQUIRE(first.faces.size() == second.faces.size());
    for (const auto& f : first.faces) {
        double nearest = 1;
        for (const auto& g : second.faces)
            if (f.master == g.master && g.other == FaceIndex{6 - f.other.q, f.other.p}) nearest = (f.area - g.area).norm();
        CHECK(nearest < 1e-15);
    }
}
