// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/largest_rate.hpp"
#include <algorithm>

namespace physics {

/// rate_of(b, i, j, k): that of a cell [1/s].
template <class RateOf>
static tasks::Job find_largest(tasks::Lane& lane, const core::Mesh& mesh, RateOf rate_of, double& rate)
{
    std::vector<double> largest(std::size_t(mesh.own_count()), 0.0);
    lane.team().run(mesh.own_count(), [&](int b) {
        double& most = largest[std::size_t(b)];
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) { most = std::max(most, rate_of(b, i, j, k)); });
    });
    rate = 0;
    for (const double r : largest) rate = std::max(rate, r);
    co_await lane.max(std::span(&rate, 1));
}

tasks::Job find_largest_rate(tasks::Lane& lane, const core::Mesh& mesh, const core::ScalarField& through, const core::ScalarField& share,
                             double& rate)
{
    const auto rate_of = [&](core::LocalBlock b, int i, int j, int k) {
        return through.on(b)(i, j, k) / (share.on(b)(i, j, k) * mesh.geometry(b).volume(i, j, k));
    };
    co_await find_largest(lane, mesh, rate_of, rate);
}

tasks::Job find_largest_rate(tasks::Lane& lane, const core::Mesh& mesh, const core::ScalarField& through, double& rate)
{
    const auto rate_of = [&](core::LocalBlock b, int i, int j, int k) { return through.on(b)(i, j, k) / mesh.geometry(b).volume(i, j, k); };
    co_await find_largest(lane, mesh, rate_of, rate);
}

} // namespace physics
