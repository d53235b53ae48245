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

/// What the frozen fluid does to the grains, in sub-steps of h: v <- decay v + drift + give * contact force.
struct Column::Push {
    Numbers fluid, known, load; ///< velocity; force that the fluid feels no reaction of; all at the velocity of the start
    Numbers decay, give, drift;
};

physics::GrainCoupling Column::coupling_of(std::size_t i) const { return {mass_, volume_, drag_[i] * scene_.dt, added_, growth_[i]}; }

Column::Push Column::push_of(const Told& told, double h) const
{
    const Numbers acceleration = sampled(told.acceleration), g = sampled(told.force), first = sampled(u_);
    Push push{sampled(told.velocity), {}, {}, {}, {}, {}};
    const double mass = mass_ + added_;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const double x = std::max(drag_[i] * h / mass, 1e-9), yield = 1.0 - share_[i];
        const physics::GrainCoupling grain = coupling_of(i);
        const double u = push.fluid[i] = first[i] + (push.fluid[i] - first[i]) * physics::seen_share(grain.growth, yield);
        push.decay.push_back(std::exp(-x));
        push.give.push_back(-std::expm1(-x) / x * h / mass);
        push.known.push_back(weight_ + owed_[i] / scene_.dt + volume_ * g[i]);
        const double force = push.known[i] + (delivery_factor(grain, yield) - 1.0) * owed_[i] / scene_.dt + added_ * acceleration[i];
        push.load.push_back(force + drag_[i] * (u - velocity_[i]));
        push.drift.push_back((1.0 - push.decay[i]) * u + push.give[i] * force);
    }
    return push;
}

/// What each grain received of the fluid, and the share of its load that contacts carried.
void Column::close(const Push& push, Lane& lane) const
{
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const double applied = mass_ * (lane.velocity[i] - velocity_[i]) - lane.contact[i];
        lane.exchanged.push_back(applied - push.known[i] * scene_.dt);
        lane.share.push_back(physics::contact_share(lane.contact[i] * applied, applied * applied));
    }
}

/// Free flight, held back by the contacts of the last step, from place.
Column::Lane Column::fly(const Told& told) const
{
    const Push push = push_of(told, scene_.dt);
    Lane lane{place_, velocity_, {}, {}, {}};
    for (std::size_t i = 0; i < place_.size(); ++i) {
        lane.contact.push_back(-share_[i] * scene_.dt * push.load[i]);
        lane.velocity[i] += (1.0 - share_[i]) * (push.decay[i] * velocity_[i] + push.drift[i] - velocity_[i]);
    }
    close(push, lane);
    return lane;
}

Column::Lane Column::advance(const Told& told, int substeps) const
{
    const double h = scene_.dt / substeps;
    const Push push = push_of(told, h);
    const std::size_t count = place_.size();
    Lane lane{place_, velocity_, Numbers(count, 0.0), {}, {}};
    Numbers force(count);
    for (int k = 0; k < substeps; ++k) {
        double plate = 0.0;
        contacts(lane, force, plate);
        lane.plate += h * plate;
        for (std::size_t i = 0; i < count; ++i) {
            lane.velocity[i] = push.decay[i] * lane.velocity[i] + push.drift[i] + push.give[i] * force[i];
            lane.place[i] += h * lane.velocity[i];
            lane.contact[i] += h * force[i];
        }
    }
    close(push, lane);
    return lane;
}

} // namespace testing
