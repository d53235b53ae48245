// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/box.hpp"
#include "core/grid/hexahedron.hpp"
#include "physics/fluid/transposed_stress.hpp"
#include <doctest/doctest.h>

using core::Vec3;

TEST_CASE("where viscosity grows along a direction, the transposed stress is its growth times the gradient along that direction")
{
    // div(nu' (grad u)^T) = grad nu' . d u / d x_c for a linear velocity; on a sheared grid, whose faces are planes.
    const auto sheared = [](const Vec3& x) { return Vec3(x.x() + 0.3 * x.y(), x.y() - 0.2 * x.z(), x.z() + 0.1 * x.x()); };
    const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {5, 4, 6}, {1, 1, 1}, {}}, sheared), 0, 1);
    const auto walls = physics::make_walls(mesh, {});
    const auto& geometry = mesh.geometry(0);
    core::Mat3 slope; // row j: gradient of u_j
    slope << 1, -2, 0.5, 3, 1, -1, 0.2, 4, -2;
    const Vec3 growth(0.7, -1.1, 0.4);
    const double viscosity = 0.01;
    std::array<core::VectorField, 3> gradients{core::VectorField({"x", "", 1, false}, mesh.own_cells()),
                                               core::VectorField({"y", "", 1, false}, mesh.own_cells()),
                                               core::VectorField({"z", "", 1, false}, mesh.own_cells())};
    for (int j = 0; j < 3; ++j) {
        auto& g = gradients[std::size_t(j)];
        g.allocate();
        for (std::size_t c = 0; c < 3; ++c) std::fill(g.data(0, c).begin(), g.data(0, c).end(), slope(j, int(c)));
    }
    core::FaceField ratio({"ratio", "", 0, false}, mesh.own_cells()), scratch({"scratch", "", 0, false}, mesh.own_cells());
    core::VectorField out({"out", "", 0, false}, mesh.own_cells());
    ratio.allocate();
    scratch.allocate();
    out.allocate();
    for (int axis = 0; axis < 3; ++axis)
        core::for_each_cell(ratio.on(0).along(axis).extents(), [&](int i, int j, int k) {
            const Vec3 centre = core::face_shape(core::face_corners(mesh.vertices(0), axis, {i, j, k})).centre;
            ratio.on(0).along(axis)(i, j, k) = 5 + growth.dot(centre);
        });
    physics::add_transposed_stress(
        {geometry, walls[0], viscosity, {gradients[0].on(0), gradients[1].on(0), gradients[2].on(0)}, ratio.on(0)}, 2.0, scratch.on(0),
        out.on(0));
    double worst = 0;
    core::for_each({1, 1, 1}, {4, 3, 5}, [&](int i, int j, int k) { // boundaries have none
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(out.on(0).component(c)(i, j, k) - 2.0 * viscosity * growth.dot(slope.col(c))));
    });
    CHECK(worst < 1e-14);
}
