// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/limited_momentum.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/index_space.hpp"
#include "physics/fluid/limited_value.hpp"
#include "physics/fluid/sub_face_flux.hpp"

#include <limits>

namespace physics {
namespace {

using core::FaceView, core::VectorView, core::View;

/// Three rows, one for each component, read in the cell before a face or behind it.
struct VectorRow {
    const double *x, *y, *z;
    std::ptrdiff_t back;
    VectorRow(VectorView<const double> v, int axis, int j, int k)
        : x(v.x.row(j, k)), y(v.y.row(j, k)), z(v.z.row(j, k)), back(v.x.stride(axis))
    {
    }
    /// All read, so that nothing branches.
    [[nodiscard]] Components choose(bool before, int i) const
    {
        const double ax = x[i - back], ay = y[i - back], az = z[i - back], bx = x[i], by = y[i], bz = z[i];
        return {before ? ax : bx, before ? ay : by, before ? az : bz};
    }
};

struct OutRow {
    double *x, *y, *z;
    OutRow(const MomentumFlux& out, int axis, int j, int k)
        : x(out[0].along(axis).row(j, k)), y(out[1].along(axis).row(j, k)), z(out[2].along(axis).row(j, k))
    {
    }
};

Components operator-(const Components& a, const Components& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

void limited_flux_along(const LimitedMomentum& m, int axis, const MomentumFlux& out)
{
    const auto flux = m.flux.along(axis);
    const core::Extents n = flux.extents();
    const auto& geometry = m.transport.geometry;
    const auto& place = m.transport.centres[std::size_t(axis)];
    const VectorView<const double> centres{geometry.centre_x.view(), geometry.centre_y.view(), geometry.centre_z.view()};
    const double half = 0.5 * m.dt;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *f = flux.row(j, k), *fx = place[0].view().row(j, k), *fy = place[1].view().row(j, k),
                         *fz = place[2].view().row(j, k);
            const VectorRow velocity(m.carried.velocity, axis, j, k), middle(m.carried.middle, axis, j, k), w(m.carrier, axis, j, k),
                gx(m.carried.gradients[0], axis, j, k), gy(m.carried.gradients[1], axis, j, k), gz(m.carried.gradients[2], axis, j, k),
                x(centres, axis, j, k);
            const OutRow o(out, axis, j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const bool from_low = f[i] > 0;
                const Components here = x.choose(from_low, i), face{fx[i], fy[i], fz[i]};
                const UpwindCell cell{
                    velocity.choose(from_low, i), velocity.choose(!from_low, i), middle.choose(from_low, i), w.choose(from_low, i),
                    gx.choose(from_low, i),       gy.choose(from_low, i),        gz.choose(from_low, i),     face - here,
                    x.choose(!from_low, i) - here};
                const Components value = limited_value(cell, half);
                o.x[i] = f[i] * value.x;
                o.y[i] = f[i] * value.y;
                o.z[i] = f[i] * value.z;
            }
        }
}

Components upwind_of(const core::SubFaceMetrics& s, bool from_a, VectorView<const double> q)
{
    const auto of = [&](View<const double> component) {
        const SubFacePair pair = pair_at(s, component);
        return from_a ? pair.a : pair.b;
    };
    return {of(q.x), of(q.y), of(q.z)};
}

Components components(const core::Vec3& v) { return {v.x(), v.y(), v.z()}; }

void put(const MomentumFlux& out, int sub_face, double flux, const Components& value)
{
    out[0].sub_faces(sub_face, 0, 0) = flux * value.x;
    out[1].sub_faces(sub_face, 0, 0) = flux * value.y;
    out[2].sub_faces(sub_face, 0, 0) = flux * value.z;
}

void limited_flux_through_sub_faces(const LimitedMomentum& m, const MomentumFlux& out)
{
    const auto& geometry = m.transport.geometry;
    const CarriedVelocity& c = m.carried;
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const core::SubFaceMetrics& s = geometry.sub_faces[n];
        const double f = m.flux.sub_faces(int(n), 0, 0);
        const bool from_a = f > 0;
        const core::Vec3 a_to_b = s.from_a - s.from_b, to_face = from_a ? s.from_a : s.from_b;
        const UpwindCell cell{upwind_of(s, from_a, c.velocity),
                              upwind_of(s, !from_a, c.velocity),
                              upwind_of(s, from_a, c.middle),
                              upwind_of(s, from_a, m.carrier),
                              upwind_of(s, from_a, c.gradients[0]),
                              upwind_of(s, from_a, c.gradients[1]),
                              upwind_of(s, from_a, c.gradients[2]),
                              components(to_face),
                              components(from_a ? a_to_b : core::Vec3(-a_to_b))};
        put(out, int(n), f, limited_value(cell, 0.5 * m.dt));
    }
    for (const auto& component : out) sum_sub_faces(geometry, component);
}

void upwind_flux_along(int axis, FaceView<const double> all, VectorView<const double> velocity, const MomentumFlux& out)
{
    const auto flux = all.along(axis);
    const core::Extents n = flux.extents();
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double* f = flux.row(j, k);
            const VectorRow u(velocity, axis, j, k);
            const OutRow o(out, axis, j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const Components value = u.choose(f[i] > 0, i);
                o.x[i] = f[i] * value.x;
                o.y[i] = f[i] * value.y;
                o.z[i] = f[i] * value.z;
            }
        }
}

} // namespace

void limited_momentum_flux(const LimitedMomentum& m, const MomentumFlux& out)
{
    for (int axis = 0; axis < 3; ++axis) limited_flux_along(m, axis, out);
    limited_flux_through_sub_faces(m, out);
    const FlowBoundaries boundaries{m.transport.geometry, m.transport.walls_before, m.transport.walls};
    for (int c = 0; c < 3; ++c) boundary_momentum_flux(boundaries, c, m.flux, m.carried.middle, out[std::size_t(c)]);
}

void upwind_momentum_flux(const FlowBoundaries& boundaries, FaceView<const double> flux, VectorView<const double> velocity,
                          const MomentumFlux& out)
{
    for (int axis = 0; axis < 3; ++axis) upwind_flux_along(axis, flux, velocity, out);
    const auto& geometry = boundaries.geometry;
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const double f = flux.sub_faces(int(n), 0, 0);
        put(out, int(n), f, upwind_of(geometry.sub_faces[n], f > 0, velocity));
    }
    for (int c = 0; c < 3; ++c) {
        sum_sub_faces(geometry, out[std::size_t(c)]);
        boundary_momentum_flux(boundaries, c, flux, velocity, out[std::size_t(c)]);
    }
}

void carry_momentum(const SharedCells& cells, FaceView<const double> flux, const KnownMomentumFlux& momentum, View<double> share_after,
                    VectorView<double> velocity_after)
{
    const auto volume = cells.geometry.volume.view();
    net_outflow(flux, share_after);
    for (int c = 0; c < 3; ++c) {
        net_outflow(momentum[std::size_t(c)], velocity_after.component(c));
        // In terms of what differs from the velocity of the cell: round-off does not grow with that.
        map_cells(
            velocity_after.component(c),
            [dt = cells.dt](double out, double net, double u, double w, double v) { return u - dt * (out - net * u) / (w * v - dt * net); },
            velocity_after.component(c), share_after, cells.velocity.component(c), cells.share, volume);
    }
    double least = std::numeric_limits<double>::infinity();
    map_cells(
        share_after, [dt = cells.dt](double net, double w, double v) { return w - dt * net / v; }, share_after, cells.share, volume);
    core::for_each_cell(cells.geometry.cells, [&](int i, int j, int k) { least = std::min(least, share_after(i, j, k)); });
    core::require<core::NumericsError>(
        least > 0, core::text("block ", cells.block, ": in a step of ", cells.dt, " s all fluid leaves a cell: make the step smaller"));
}

double largest_outflow_rate(const core::BlockGeometry& geometry, FaceView<const double> flux, View<const double> share,
                            View<double> scratch)
{
    outflow_of_cells(geometry, flux, scratch);
    const auto volume = geometry.volume.view();
    double most = 0;
    core::for_each_cell(geometry.cells,
                        [&](int i, int j, int k) { most = std::max(most, scratch(i, j, k) / (share(i, j, k) * volume(i, j, k))); });
    return most;
}

} // namespace physics
