// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/bounded_transport.hpp"
#include "core/grid/hexahedron.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/faces_of_cells.hpp"
#include "physics/fluid/sub_face_transport.hpp"

namespace physics {
namespace {

/// What leaves a cell through two faces that lie across from each other; with the faces exchanged, what enters.
double leaving(double low, double high) { return std::max(high, 0.0) - std::min(low, 0.0); }

/// Calls store(j, k)(i, flux, upwind value, what high order adds to it) for every face along an axis.
template <class Store>
void for_each_face_value(const core::BlockGeometry& geometry, const FaceCentres& centres, int axis, core::View<const double> flux,
                         const CarriedValue& q, Store store)
{
    const core::Extents n = flux.extents();
    const auto cx = geometry.centre_x.view(), cy = geometry.centre_y.view(), cz = geometry.centre_z.view();
    const std::ptrdiff_t c = cx.stride(axis), s = q.value.stride(axis), m = q.half.stride(axis), g = q.gradient.x.stride(axis);
    const auto& place = centres[std::size_t(axis)];
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *f = flux.row(j, k), *x = cx.row(j, k), *y = cy.row(j, k), *z = cz.row(j, k);
            const double *fx = place[0].view().row(j, k), *fy = place[1].view().row(j, k), *fz = place[2].view().row(j, k);
            const double *v = q.value.row(j, k), *h = q.half.row(j, k);
            const double *gx = q.gradient.x.row(j, k), *gy = q.gradient.y.row(j, k), *gz = q.gradient.z.row(j, k);
            const auto put = store(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const bool along = f[i] > 0;
                const double value = along ? v[i - s] : v[i], beyond = along ? v[i] : v[i - s], half = along ? h[i - m] : h[i];
                const double slope_x = along ? gx[i - g] : gx[i], slope_y = along ? gy[i - g] : gy[i], slope_z = along ? gz[i - g] : gz[i];
                const double to_face = slope_x * (fx[i] - (along ? x[i - c] : x[i])) + slope_y * (fy[i] - (along ? y[i - c] : y[i])) +
                                       slope_z * (fz[i] - (along ? z[i - c] : z[i]));
                const double along_line = slope_x * (x[i] - x[i - c]) + slope_y * (y[i] - y[i - c]) + slope_z * (z[i] - z[i - c]);
                const double bend = (beyond - value) - (along ? along_line : -along_line);
                put(i, f[i], value, (half - value) + to_face + share_of_second_difference * bend);
            }
        }
}

void reduce_along(int axis, core::View<const double> gain, core::View<const double> loss, core::View<double> added)
{
    const core::Extents n = added.extents();
    const std::ptrdiff_t s = gain.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *take = gain.row(j, k), *give = loss.row(j, k);
            double* a = added.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) a[i] *= a[i] > 0 ? std::min(take[i], give[i - s]) : std::min(take[i - s], give[i]);
        }
}

} // namespace

FaceCentres face_centres(const core::Vertices& vertices)
{
    FaceCentres centres;
    const core::Extents cells = core::cells_of(vertices);
    for (int axis = 0; axis < 3; ++axis) {
        core::Extents faces = cells;
        (axis == 0 ? faces.ni : axis == 1 ? faces.nj : faces.nk) += 1;
        auto& of_axis = centres[std::size_t(axis)];
        for (auto& component : of_axis) component = core::Array3<double>(faces);
        core::for_each_cell(faces, [&](int i, int j, int k) {
            const core::Vec3 centre = core::face_shape(core::face_corners(vertices, axis, {i, j, k})).centre;
            for (int m = 0; m < 3; ++m) of_axis[std::size_t(m)](i, j, k) = centre[m];
        });
    }
    return centres;
}

void middle_of_step(double dt, core::View<const double> share, core::VectorView<const double> carrier, core::View<const double> value,
                    core::VectorView<const double> gradient, core::View<double> half)
{
    map_cells(
        half,
        [h = 0.5 * dt](double w, double q, double u, double v, double t, double x, double y, double z) {
            return q - h * (u * x + v * y + t * z) / w;
        },
        share, value, carrier.x, carrier.y, carrier.z, gradient.x, gradient.y, gradient.z);
}

void transport_fluxes(const core::BlockGeometry& geometry, const FaceCentres& centres, core::FaceView<const double> flux,
                      const CarriedValue& q, core::FaceView<double> upwind, core::FaceView<double> added)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = upwind.along(axis), high = added.along(axis);
        for_each_face_value(geometry, centres, axis, flux.along(axis), q, [=](int j, int k) {
            return [up = low.row(j, k), more = high.row(j, k)](int i, double f, double value, double addition) {
                up[i] = f * value;
                more[i] = f * addition;
            };
        });
    }
    sub_face_transport_fluxes(geometry, flux, q, upwind, added);
}

void transport_flux(const core::BlockGeometry& geometry, const FaceCentres& centres, core::FaceView<const double> flux,
                    const CarriedValue& q, core::FaceView<double> out)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto all = out.along(axis);
        for_each_face_value(geometry, centres, axis, flux.along(axis), q, [=](int j, int k) {
            return [o = all.row(j, k)](int i, double f, double value, double addition) { o[i] = f * (value + addition); };
        });
    }
}

void outflow_of_cells(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::View<double> outflow)
{
    map_faces_of_cells(outflow, flux, [](double low_i, double high_i, double low_j, double high_j, double low_k, double high_k) {
        return leaving(low_i, high_i) + leaving(low_j, high_j) + leaving(low_k, high_k);
    });
    for (const core::JoinedCell& at : geometry.joined_cells) outflow[at.cell] = outflow_of(geometry, at, flux);
}

double largest_outflow_rate(const core::BlockGeometry& geometry, core::FaceView<const double> flux)
{
    const auto volume = geometry.volume.view();
    const core::Extents n = geometry.cells;
    double most = 0;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *fi = flux.i.row(j, k), *low_j = flux.j.row(j, k), *high_j = flux.j.row(j + 1, k), *low_k = flux.k.row(j, k),
                         *high_k = flux.k.row(j, k + 1), *v = volume.row(j, k);
#pragma omp simd reduction(max : most)
            for (int i = 0; i < n.ni; ++i)
                most = std::max(most, (leaving(fi[i], fi[i + 1]) + leaving(low_j[i], high_j[i]) + leaving(low_k[i], high_k[i])) / v[i]);
        }
    for (const core::JoinedCell& at : geometry.joined_cells) most = std::max(most, outflow_of(geometry, at, flux) / volume[at.cell]);
    return most;
}

void flux_shares(const core::BlockGeometry& geometry, core::View<const double> value, core::View<const double> low,
                 core::View<const double> capacity, core::FaceView<const double> added, core::View<double> gain, core::View<double> loss)
{
    const core::Extents n = low.extents();
    const std::ptrdiff_t sj = value.stride(1), sk = value.stride(2);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *v = value.row(j, k), *q = low.row(j, k), *room = capacity.row(j, k), *fi = added.i.row(j, k);
            const double *low_j = added.j.row(j, k), *high_j = added.j.row(j + 1, k), *low_k = added.k.row(j, k),
                         *high_k = added.k.row(j, k + 1);
            double *take = gain.row(j, k), *give = loss.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double most =
                    std::max({std::max({v[i], v[i - 1], v[i + 1]}), std::max(v[i - sj], v[i + sj]), std::max(v[i - sk], v[i + sk])});
                const double least =
                    std::min({std::min({v[i], v[i - 1], v[i + 1]}), std::min(v[i - sj], v[i + sj]), std::min(v[i - sk], v[i + sk])});
                const double in = leaving(fi[i + 1], fi[i]) + leaving(high_j[i], low_j[i]) + leaving(high_k[i], low_k[i]);
                const double out = leaving(fi[i], fi[i + 1]) + leaving(low_j[i], high_j[i]) + leaving(low_k[i], high_k[i]);
                take[i] = share_within(most - q[i], room[i], in);
                give[i] = share_within(q[i] - least, room[i], out);
            }
        }
    sub_face_flux_shares(geometry, value, low, capacity, added, gain, loss);
}

void reduce_fluxes(const core::BlockGeometry& geometry, core::View<const double> gain, core::View<const double> loss,
                   core::FaceView<double> added)
{
    for (int axis = 0; axis < 3; ++axis) reduce_along(axis, gain, loss, added.along(axis));
    reduce_sub_face_fluxes(geometry, gain, loss, added);
}

} // namespace physics
