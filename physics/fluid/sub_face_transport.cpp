// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sub_face_transport.hpp"
#include "physics/fluid/sub_face_flux.hpp"

#include <algorithm>

namespace physics {
namespace {

/// Of a cell: what flows out of it through all its faces and sub-faces, and what flows in.
struct Exchange {
    double out = 0, in = 0;
    void add(double outward)
    {
        out += std::max(outward, 0.0);
        in += std::max(-outward, 0.0);
    }
};

Exchange exchange_of(const core::BlockGeometry& geometry, const core::JoinedCell& at, core::FaceView<const double> flux)
{
    Exchange sum;
    for (const core::Side side : core::all_sides) {
        if (at.joined[std::size_t(side)]) continue;
        core::Index3 face = at.cell;
        if (core::is_high(side)) ++face[core::axis_of(side)];
        const double along = flux.along(core::axis_of(side))[face];
        sum.add(core::is_high(side) ? along : -along);
    }
    for (const int n : at.sub_faces) sum.add(geometry.sub_faces[std::size_t(n)].is_a ? flux.sub_faces(n, 0, 0) : -flux.sub_faces(n, 0, 0));
    return sum;
}

/// Least and largest of the old values of a cell and its neighbours.
std::pair<double, double> range_around(const core::BlockGeometry& geometry, const core::JoinedCell& at, core::View<const double> value)
{
    std::pair range(value[at.cell], value[at.cell]);
    const auto include = [&](double v) { range = {std::min(range.first, v), std::max(range.second, v)}; };
    for (const core::Side side : core::all_sides) {
        if (at.joined[std::size_t(side)]) continue;
        core::Index3 beside = at.cell;
        beside[core::axis_of(side)] += core::is_high(side) ? 1 : -1;
        include(value[beside]);
    }
    for (const int n : at.sub_faces) include(value.behind_halo(geometry.sub_faces[std::size_t(n)].beyond));
    return range;
}

core::Vec3 upwind_gradient(const core::SubFaceMetrics& s, bool from_a, core::VectorView<const double> gradient)
{
    const auto of = [&](core::View<const double> g) { return from_a ? pair_at(s, g).a : pair_at(s, g).b; };
    return {of(gradient.x), of(gradient.y), of(gradient.z)};
}

} // namespace

void sub_face_transport_fluxes(const core::BlockGeometry& geometry, core::FaceView<const double> flux, const CarriedValue& q,
                               core::FaceView<double> upwind, core::FaceView<double> added)
{
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const core::SubFaceMetrics& s = geometry.sub_faces[n];
        const double f = flux.sub_faces(int(n), 0, 0);
        const bool from_a = f > 0;
        const SubFacePair values = pair_at(s, q.value), halves = pair_at(s, q.half);
        const double value = from_a ? values.a : values.b, beyond = from_a ? values.b : values.a, half = from_a ? halves.a : halves.b;
        const core::Vec3 slope = upwind_gradient(s, from_a, q.gradient), a_to_b = s.from_a - s.from_b;
        const double bend = (beyond - value) - slope.dot(from_a ? a_to_b : core::Vec3(-a_to_b));
        upwind.sub_faces(int(n), 0, 0) = f * value;
        added.sub_faces(int(n), 0, 0) = f * ((half - value) + slope.dot(from_a ? s.from_a : s.from_b) + share_of_second_difference * bend);
    }
    sum_sub_faces(geometry, upwind);
    sum_sub_faces(geometry, added);
}

double outflow_of(const core::BlockGeometry& geometry, const core::JoinedCell& at, core::FaceView<const double> flux)
{
    return exchange_of(geometry, at, flux).out;
}

void sub_face_flux_shares(const core::BlockGeometry& geometry, core::View<const double> value, core::View<const double> low,
                          core::View<const double> capacity, core::FaceView<const double> added, core::View<double> gain,
                          core::View<double> loss)
{
    for (const core::JoinedCell& at : geometry.joined_cells) {
        const Exchange exchange = exchange_of(geometry, at, added);
        const auto [least, most] = range_around(geometry, at, value);
        gain[at.cell] = share_within(most - low[at.cell], capacity[at.cell], exchange.in);
        loss[at.cell] = share_within(low[at.cell] - least, capacity[at.cell], exchange.out);
    }
}

void reduce_sub_face_fluxes(const core::BlockGeometry& geometry, core::View<const double> gain, core::View<const double> loss,
                            core::FaceView<double> added)
{
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const SubFacePair take = pair_at(geometry.sub_faces[n], gain), give = pair_at(geometry.sub_faces[n], loss);
        double& a = added.sub_faces(int(n), 0, 0);
        a *= a > 0 ? std::min(take.b, give.a) : std::min(take.a, give.b);
    }
    sum_sub_faces(geometry, added);
}

} // namespace physics
