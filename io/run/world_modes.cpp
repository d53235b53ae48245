// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// By which coupling mode a World steps, and why.
#include "core/base/error.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/world.hpp"
#include "io/run/world_grains.hpp"

#include <cmath>

namespace io {

/// Extremes of all ranks, for steps of `dt` [s].
physics::StabilityNumbers World::stability(double dt) const
{
    double grains = double(grains_->particles.owned);
    ranks_.sum(std::span(&grains, 1));
    const physics::StabilityNumbers own =
        coupling_->stability(dt, bed_stiffness(bed_contact_, gravity_of(scene_), census_, grains_->domain(), grains));
    std::array greatest{own.stiffness, own.loading, own.amplification, own.solid_fraction, own.softness};
    ranks_.max(greatest);
    return {greatest[0], greatest[1], greatest[2], greatest[3], grains * sub_steps_ / double(mesh_.total_cells()), greatest[4]};
}

/// What the graph is made for, and other graphs only on demand.
void World::plan_mode()
{
    tasks::run(ranks_, core::SerialTeam(), [&](tasks::Lane& lane) { return coupling_->find_fraction(lane); });
    const physics::ModeChoice expected = physics::mode_of_step(asked_mode_, stability(next_step()), 1);
    planned_mode_ = asked_mode_.value_or(expected.mode);
    if (expected.mode != physics::Mode::iterated)
        told_modes_.insert(expected.mode); // which costs three times as much: a warning when it comes
    mode_reason_ = expected.reason;
    if (asked_mode_ != physics::Mode::iterated) mode_reason_ += "; so it seems at the start, where the first step is iterated";
}

physics::Mode World::choose_mode()
{
    const auto step = clock().step;
    const physics::StabilityNumbers numbers = stability(clock().dt);
    const physics::ModeChoice choice = physics::mode_of_step(asked_mode_, numbers, step);
    mode_reason_ = choice.reason;
    coupling_->bed_gives_way = physics::gives_way(numbers.stiffness * numbers.loading, numbers.softness);
    if (coupling_->bed_gives_way && !told_of_soft_springs_) {
        told_of_soft_springs_ = true;
        // Hertz' springs under a given load stiffen with the power 2/3 of the modulus
        const bool linear = scene_.contact->law == ContactLaw::linear;
        const double factor = std::pow(numbers.softness / physics::swaying_softness, linear ? 1.0 : 1.5);
        warnings_.push_back(
            core::text("springs are soft against drag, K/(k dt) = ", numbers.softness, " where ", physics::swaying_softness,
                       " holds a bed: it goes with the fluid, and grains resist less what flows between them; for beds that "
                       "hold, make contact.",
                       linear ? "stiffness " : "young_modulus ", factor, " times as large"));
    }
    if (step > 0 && choice.mode != asked_mode_ && told_modes_.insert(choice.mode).second) { // it may come and go
        const bool safer = choice.mode == physics::Mode::iterated;
        (safer ? warnings_ : notes_).push_back(core::text("coupling in step ", step, " and wherever else it is needed: ", choice.reason));
    }
    return choice.mode;
}

World::OtherMode& World::add_mode(physics::Mode mode)
{
    OtherMode& other = others_.try_emplace(mode, layout(), ranks_).first->second;
    other.graph.fill_halos_with(halos_);
    coupling_->declare(other.graph, mode);
    if (scalars_) scalars_->declare(other.graph);
    other.plan.emplace(other.graph.compile());
    return other;
}

tasks::Executor& World::executor_of(physics::Mode mode)
{
    if (!others_.contains(mode)) {
        add_mode(mode);
        initialise();
    }
    OtherMode& other = others_.at(mode);
    if (!other.executor) other.executor = tasks::make_executor(other_options_, *other.plan);
    return *other.executor;
}

std::string World::mode_counts() const
{
    std::string text;
    for (const auto& [mode, steps] : steps_of_mode_)
        text += core::text(text.empty() ? "" : ", ", steps, steps == 1 ? " step " : " steps ", physics::name(mode));
    return text;
}

} // namespace io
