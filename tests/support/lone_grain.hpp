// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One grain in fluid that nothing disturbs, loaded and moved as in a coupled step: what formulas of forces add up to.
#include "physics/coupling/grain_exchange.hpp"

namespace test {

class LoneGrain {
public:
    LoneGrain(const physics::CouplingParameters& parameters, double diameter, double density)
        : parameters_(parameters),
          exchange_(parameters, physics::add_wet_columns(grains_), physics::add_exchange_columns(grains_, parameters)),
          views_(physics::grain_news, std::vector<double>(1, 0.0))
    {
        core::Sphere sphere;
        sphere.radius = 0.5 * diameter;
        sphere.density = density;
        grains_.add(sphere);
        views_.resize(std::max<std::size_t>(physics::grain_views, physics::grain_news), std::vector<double>(1, 0.0));
    }
    void set_fluid(const core::Vec3& velocity)
    {
        for (std::size_t a = 0; a < 3; ++a) views_[physics::view_velocity + a][0] = velocity[int(a)];
    }
    /// One step in one sub-step.
    void step(double dt)
    {
        const physics::GrainSurroundings around{{fraction}, {}, {}};
        exchange_.remember_told(grains_, views_);
        exchange_.freeze_drag(grains_, views_, around, {dt, dt, dt});
        exchange_.load(grains_, views_, core::Vec3::Zero(), {dt, dt, dt});
        const auto& wet = exchange_.wet_columns();
        for (std::size_t a = 0; a < 3; ++a) {
            double& v = grains_.velocity[a][0];
            v = grains_.columns[std::size_t(wet.keep)][0] * v + grains_.columns[std::size_t(wet.drift) + a][0];
        }
        holds_.find(grains_.id, {}, exchange_.impulses(grains_));
        exchange_.owe(grains_, {views_, holds_, dt}, views_); // the fluid has not changed: nothing is owed, but history is kept
    }
    [[nodiscard]] core::Vec3 velocity() const { return grains_.velocity_of(0); }

    double fraction = 1.0;

private:
    physics::CouplingParameters parameters_;
    core::ParticleSet grains_;
    physics::GrainExchange exchange_;
    physics::GrainTable views_;
    physics::GrainHolds holds_;
};

} // namespace test
