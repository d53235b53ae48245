// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/largest_rate.hpp"
#include <algorithm>

namespace physics {

tasks::Job find_largest_rate(tasks::Lane& lane, const core::Mesh& mesh, const core::ScalarField& through, const core::ScalarField& share,
                             double& rate)
{
    std::vector<double> largest(std::size_t(mesh.own_count()), 0.0);
    lane.team().run(mesh.own_count(), [&](int b) {
        const core::View<const double> q = through.on(b), w = share.on(b), volume = mesh.geometry(b).volume.view();
        double& most = largest[std::size_t(b)];
        core::for_each_cell(q.extents(), [&](int i, int j, int k) { most = std::max(most, q(i, j, k) / (w(i, j, k) * volume(i, j, k))); });
    });
    rate = 0;
    for (const double r : largest) rate = std::max(rate, r);
    co_await lane.max(std::span(&rate, 1));
}

} // namespace physics
