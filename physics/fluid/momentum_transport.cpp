// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/momentum_transport.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/sub_face_momentum.hpp"

namespace physics {

void middle_flux(double weight, core::FaceView<const double> flux, core::FaceView<double> before, core::FaceView<double> middle)
{
    map_faces(
        middle, [weight](double now, double old) { return now + weight * (now - old); }, flux, before);
    map_faces(
        before, [](double now) { return now; }, flux);
}

void middle_velocity(double dt, core::VectorView<const double> transport, core::VectorView<const double> q,
                     const std::array<core::VectorView<const double>, 3>& gradients, core::VectorView<double> middle)
{
    for (int c = 0; c < 3; ++c) {
        const auto& g = gradients[std::size_t(c)];
        map_cells(
            middle.component(c),
            [h = 0.5 * dt](double value, double u, double v, double w, double x, double y, double z) {
                return value - h * (u * x + v * y + w * z);
            },
            q.component(c), transport.x, transport.y, transport.z, g.x, g.y, g.z);
    }
}

void boundary_momentum_flux(const FlowBoundaries& boundaries, int component, core::FaceView<const double> flux,
                            core::VectorView<const double> inside, core::FaceView<double> out)
{
    for (const core::Side side : core::all_sides) {
        const BlockSide &before = boundaries.before.at(side), &after = boundaries.after.at(side);
        if (!after.kind) continue;
        const auto f = flux.along(core::axis_of(side));
        const auto o = out.along(core::axis_of(side));
        for_each_side_face(boundaries.geometry.cells, side, [&](int i, int j, int k) {
            const core::Index3 face{i, j, k}, c = cell_at_face(face, side);
            const core::Vec3 within(inside.x[c], inside.y[c], inside.z[c]);
            const double outward = core::is_high(side) ? f[face] : -f[face];
            const core::Vec3 twice = carried_through(before, c, outward, within) + carried_through(after, c, outward, within);
            o[face] = f[face] * 0.5 * twice[component];
        });
    }
}

void momentum_outflow(const MomentumTransport& transport, core::FaceView<const double> flux, const CarriedVelocity& carried,
                      core::FaceView<double> scratch, core::VectorView<double> outflow)
{
    for (int c = 0; c < 3; ++c) {
        const CarriedValue value{carried.velocity.component(c), carried.middle.component(c), carried.gradients[std::size_t(c)]};
        transport_flux(transport.geometry, transport.centres, flux, value, scratch);
        close_joined(transport.geometry, scratch);
        boundary_momentum_flux({transport.geometry, transport.walls_before, transport.walls}, c, flux, carried.middle, scratch);
        net_outflow(scratch, outflow.component(c));
    }
}

void require_stable_outflow(double rate, core::BlockId block, double dt)
{
    constexpr double most = 1.25; // below 1.35, for cells that are not alike
    if (!(rate * dt <= most))     // else no message is written: that takes as long as a thousand cells
        throw core::NumericsError(core::text("block ", block, ": in a step of ", dt, " s ", rate * dt,
                                             " times the fluid of a cell leaves it, finite volumes bear ", most,
                                             ": make the step smaller, or take fluid.advection: lcsi"));
}

} // namespace physics
