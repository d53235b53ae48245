// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/assumed_grains.hpp"
#include <cmath>

namespace physics {
namespace {

/// What a sub-step `factor` times as long keeps of a velocity, and how many times it gains and drifts as much.
struct Stretched {
    double keep, ratio;
};

Stretched stretched(double keep, double factor)
{
    if (keep <= 0.0) return {0.0, 1.0}; // drag so stiff that nothing is kept
    const double z = -std::log(keep);
    return {std::exp(-factor * z), z > 0.0 ? std::expm1(-factor * z) / std::expm1(-z) : factor};
}

} // namespace

void stretch_loads(core::ParticleSet& grains, const WetColumns& wet, double factor)
{
    const auto stretch = [&](int keep, int gain, int drift) {
        for (int g = 0; g < grains.owned; ++g) {
            const auto column = [&](int n) -> double& { return grains.columns[std::size_t(n)][std::size_t(g)]; };
            const auto [kept, ratio] = stretched(column(keep), factor);
            column(keep) = kept;
            column(gain) *= ratio;
            for (int a = 0; a < 3; ++a) column(drift + a) *= ratio;
        }
    };
    stretch(wet.keep, wet.gain, wet.drift);
    stretch(wet.spin_keep, wet.spin_gain, wet.spin_drift);
}

void fly(core::ParticleSet& grains, const WetColumns& wet, int hold, double dt, int sub_steps)
{
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        const auto column = [&](int n) -> double& { return grains.columns[std::size_t(n)][k]; };
        const double keep = column(wet.keep), held = column(hold);
        const auto [kept, ratio] = stretched(keep, sub_steps);
        for (int a = 0; a < 3; ++a) {
            double& velocity = grains.velocity[std::size_t(a)][k];
            const double drift = column(wet.drift + a);
            const double load = (drift - (1.0 - keep) * velocity) / column(wet.gain); // all but contacts, at this velocity [N]
            column(wet.impulse + a) = -held * dt * load;
            velocity += (1.0 - held) * (kept * velocity + ratio * drift - velocity);
        }
    }
}

} // namespace physics
