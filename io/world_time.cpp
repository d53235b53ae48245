// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// How long the next step of a World may be.
#include "core/comm/reduce.hpp"
#include "io/physics_builder.hpp"
#include "io/world.hpp"
#include "physics/fluid/time_step.hpp"
#include <cmath>

namespace io {
namespace {

constexpr int dry_batch = 100;              // sub-steps in a step of a scene without fluid
constexpr double still_steps = 200;         // steps of a fluid that nothing moves, over the whole run
constexpr double largest_distortion = 0.5;  // trajectories of neighbours must not cross within a step

/// Largest acceleration in cells per second squared that `acceleration` [m/s2] means in a block.
double index_acceleration(const core::BlockGeometry& g, const core::Vec3& acceleration)
{
    double largest = 0;
    core::for_each_cell(g.cells, [&](int i, int j, int k) {
        for (std::size_t m = 0; m < 3; ++m) {
            double a = 0;
            for (std::size_t n = 0; n < 3; ++n) a += std::abs(g.inverse_jacobian[m][n](i, j, k) * acceleration[int(n)]);
            largest = std::max(largest, a);
        }
    });
    return largest;
}

/// Largest dt with rate dt + growth dt^2 <= bound.
double time_to_reach(double bound, double rate, double growth)
{
    if (growth <= 0) return rate > 0 ? bound / rate : std::numeric_limits<double>::infinity();
    return 2 * bound / (rate + std::sqrt(rate * rate + 4 * growth * bound));
}

} // namespace

double World::fluid_limit() const
{
    core::Vec3 pull = physics::drive_direction(fluid_->parameters().drive);
    if (scene_.fluid->drive) pull *= std::abs(scene_.fluid->drive->pressure_gradient) / scene_.fluid->material.density;
    if (grains_) pull += gravity_of(scene_).cwiseAbs();
    std::array<double, 3> rates{};
    for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        const auto r = physics::transport_rates(mesh_.geometry(b), fluid_->state().velocity.on(b));
        rates[0] = std::max(rates[0], r.displacement);
        rates[1] = std::max(rates[1], r.distortion);
        rates[2] = std::max(rates[2], index_acceleration(mesh_.geometry(b), pull));
    }
    ranks_.max(rates);
    const double displacement = time_to_reach(scene_.run.limits.cfl, rates[0], rates[2]);
    const double distortion = rates[1] > 0 ? largest_distortion / rates[1] : std::numeric_limits<double>::infinity();
    const double still = scene_.run.time_step ? *scene_.run.time_step : (scene_.run.until + scene_.run.settle) / still_steps;
    return std::min({displacement, distortion, still});
}

double World::next_step()
{
    const double wanted = scene_.run.time_step.value_or(std::numeric_limits<double>::infinity());
    if (!fluid_) {
        sub_steps_ = std::isfinite(wanted) ? std::max(1, int(std::lround(wanted / grains_->step()))) : int(dry_batch * shortening_);
        return sub_steps_ * grains_->step();
    }
    const double dt = std::min(wanted, shortening_ * fluid_limit());
    if (!grains_) return dt;
    sub_steps_ = std::max(1, int(std::floor(dt / grains_->step() * (1 + 1e-12))));
    return sub_steps_ * grains_->step();
}

} // namespace io
