// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// How long the next step of a World may be.
#include "core/base/error.hpp"
#include "io/build/coupling_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/world.hpp"
#include "io/run/world_grains.hpp"
#include "physics/coupling/time_step.hpp"
#include "physics/fluid/wall_shear.hpp"
#include <cmath>

namespace io {
namespace {

constexpr int dry_batch = 100;      // sub-steps in a step of a scene without fluid
constexpr double still_steps = 200; // steps of a fluid that nothing moves, over the whole run

} // namespace

physics::TransportRates World::transport_rates(const core::Vec3& pull) const
{
    // A flow that is prescribed begins at once.
    const bool starts = clock().dt_before == 0 && fluid_->flow_control();
    const core::Vec3 start = starts ? core::Vec3(std::abs(fluid_->flow_control()->bulk_velocity(time())) *
                                                 physics::drive_direction(fluid_->parameters().drive).cwiseAbs())
                                    : core::Vec3(core::Vec3::Zero());
    const bool by_outflow = fluid_->by_finite_volumes() && pull.isZero(); // no other rate is asked for
    physics::TransportRates rates;
    for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        physics::TransportRates here;
        if (!by_outflow) here = physics::transport_rates(mesh_.geometry(b), fluid_->state().velocity.on(b), pull);
        if (fluid_->by_finite_volumes())
            here.outflow = coupling_ ? coupling_->outflow_rate(b)
                                     : physics::largest_outflow_rate(mesh_.geometry(b), std::as_const(fluid_->state()).flux.on(b));
        if (starts) {
            const physics::TransportRates begun = physics::transport_rates(mesh_.geometry(b), fluid_->state().velocity.on(b), start);
            here.displacement = std::max(here.displacement, begun.growth);
            here.outflow = std::max(here.outflow, begun.outflow_growth);
        }
        rates.widen(here);
    }
    std::array all{rates.displacement, rates.distortion, rates.growth, rates.outflow, rates.outflow_growth};
    ranks_.max(all);
    return {all[0], all[1], all[2], all[3], all[4]};
}

physics::TimeStepLimit World::limit_of_step() const
{
    const auto& drive = fluid_->parameters().drive;
    const core::Vec3 direction = physics::drive_direction(drive).cwiseAbs();
    core::Vec3 pull = physics::drive_strength(drive, clock().drive) * direction;
    if (grains_) pull += gravity_of(scene_).cwiseAbs();
    const physics::TransportRates rates = transport_rates(pull);
    physics::TimeStepOptions options;
    if (!scene_.run.time_step) options.largest = (scene_.run.until + scene_.run.settle) / still_steps;
    options.displacement = scene_.run.limits.cfl;
    // Beside grains no face may carry more than its cell has, and what it carries may grow until the middle of the step.
    constexpr double beside_grains = 0.8;
    options.outflow = std::min(scene_.run.limits.cfl, coupling_ ? beside_grains : options.outflow);
    physics::TimeStepLimit limit =
        fluid_->by_finite_volumes() ? physics::outflow_step_limit(rates, options) : physics::time_step_limit(rates, options);
    if (turbulence_ && scene_.fluid->turbulence->model == TurbulenceModel::abe_kondoh_nagano) {
        // Losses are implicit: beside a wall k grows by no more than what it would gain in its lifetime, some ten viscous times, in a
        // step of any length. In longer steps it comes back too late after a change, while the flow runs away without friction.
        constexpr double viscous_times = 100;
        std::array shear{0.0};
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b)
            shear[0] = std::max(shear[0], physics::largest_wall_shear(mesh_.geometry(b), fluid_->walls()[std::size_t(b)],
                                                                      std::as_const(fluid_->state()).velocity.on(b)));
        ranks_.max(shear);
        if (shear[0] > 0) limit.tighten(viscous_times / shear[0], "turbulence at walls");
    }
    if (coupling_ || one_way_) {
        std::array fastest{physics::largest_speed(grains_->particles)};
        ranks_.max(fastest);
        const double width = coupling_parameters(scene_, census_).filter_width;
        limit.tighten(physics::grain_move_limit(scene_.run.limits.particle_move, width, fastest[0], pull.norm()), "particle move");
    }
    if (scene_.run.time_step) limit.tighten(*scene_.run.time_step, "time_step of the scene");
    limit.dt *= shortening_;
    return limit;
}

double World::next_step()
{
    if (!fluid_) {
        const auto wanted = scene_.run.time_step;
        limit_name_ = wanted ? "time_step of the scene" : "batch of sub-steps";
        return divided(wanted.value_or(int(dry_batch * shortening_) * contact_step_));
    }
    const physics::TimeStepLimit limit = limit_of_step();
    limit_name_ = limit.binding;
    const double dt = limit.dt;
    if (!grains_) return dt;
    constexpr double most_sub_steps = 1e9;
    core::require<core::ConfigError>(
        dt < most_sub_steps * contact_step_,
        core::text("a step of ", dt, " s would need ", dt / contact_step_, " sub-steps of the grains, of ", contact_step_,
                   " s each: contacts this stiff, or grains this light, cannot be computed; look at contact.stiffness"));
    return divided(dt);
}

void World::set_sub_step(double step)
{
    if (step != grains_->step()) grains_->set_step(step);
}

double World::divided(double dt)
{
    sub_steps_ = std::max(1, int(std::floor(dt / contact_step_ * (1 + 1e-12))));
    set_sub_step(std::min(contact_step_, dt));
    return sub_steps_ * grains_->step();
}

} // namespace io
