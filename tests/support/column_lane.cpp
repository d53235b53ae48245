// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The grain lane of the test column: sub-steps with contacts in a frozen fluid.
#include "tests/support/column.hpp"

#include "physics/coupling/contact_share.hpp"

#include <algorithm>
#include <cmath>

namespace testing {

void Column::contacts(const Lane& lane, Numbers& force, double& plate) const
{
    std::fill(force.begin(), force.end(), 0.0);
    plate = 0.0;
    if (scene_.bottom == Bottom::periodic) return;
    const auto push = [this](double overlap, double approach) {
        return overlap > 0.0 ? std::max(spring_ * overlap + damper_ * approach, 0.0) : 0.0;
    };
    const std::size_t last = force.size() - 1;
    const double d = scene_.diameter;
    const double under = push(bottom_ + 0.5 * d - lane.place[0], -lane.velocity[0]);
    const double over = push(lane.place[last] + 0.5 * d - top_, lane.velocity[last]);
    force[0] += under;
    force[last] -= over;
    plate = under - over;
    for (std::size_t i = 0; i < last; ++i) {
        const double f = push(d - lane.place[i + 1] + lane.place[i], lane.velocity[i] - lane.velocity[i + 1]);
        force[i] -= f;
        force[i + 1] += f;
    }
}

Column::Lane Column::advance(const Told& told, int substeps) const
{
    const Numbers u = sampled(told.velocity), acceleration = sampled(told.acceleration), g = sampled(told.force);
    const double h = scene_.dt / substeps, mass = mass_ + added_;
    const std::size_t count = place_.size();
    Lane lane{place_, velocity_, Numbers(count, 0.0), {}, {}};
    Numbers decay, give, drift, force(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = std::max(drag_[i] * h / mass, 1e-9);
        decay.push_back(std::exp(-x));
        give.push_back(-std::expm1(-x) / x * h / mass);
        const double f = weight_ + owed_[i] / scene_.dt + volume_ * g[i] + added_ * acceleration[i];
        drift.push_back((1.0 - decay[i]) * u[i] + give[i] * f);
    }
    for (int k = 0; k < substeps; ++k) {
        double plate = 0.0;
        contacts(lane, force, plate);
        lane.plate += h * plate;
        for (std::size_t i = 0; i < count; ++i) {
            lane.velocity[i] = decay[i] * lane.velocity[i] + drift[i] + give[i] * force[i];
            lane.place[i] += h * lane.velocity[i];
            lane.contact[i] += h * force[i];
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double applied = mass_ * (lane.velocity[i] - velocity_[i]) - lane.contact[i];
        lane.exchanged.push_back(applied - (weight_ + volume_ * g[i]) * scene_.dt - owed_[i]);
        lane.share.push_back(physics::contact_share(lane.contact[i] * applied, applied * applied));
    }
    return lane;
}

} // namespace testing
