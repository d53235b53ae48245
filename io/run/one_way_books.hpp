// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The books of momentum of grains that feel a fluid which does not feel them: only theirs must balance.
#include "io/run/grain_momentum.hpp"

namespace io {

class OneWayBooks {
public:
    /// Takes the momentum of the present state. Collective. @pre world.one_way(), compiled
    explicit OneWayBooks(World& world);

    /// To be called after every step. Collective.
    void update();

    /// Of the last step [N s]: momentum and what is owed change by the sum of the impulses.
    struct Lines {
        core::Vec3 momentum = core::Vec3::Zero(); ///< of the grains, at the end of the step
        core::Vec3 owed = core::Vec3::Zero();     ///< to them
        core::Vec3 drive = core::Vec3::Zero();
        core::Vec3 weight = core::Vec3::Zero();   ///< less buoyancy
        core::Vec3 contact = core::Vec3::Zero();  ///< of walls
        core::Vec3 exchange = core::Vec3::Zero(); ///< what the fluid gave them and does not lose
        core::Vec3 couple = core::Vec3::Zero();   ///< angular impulse of its torque [N m s]
    };
    [[nodiscard]] const Lines& lines() const { return lines_; }

private:
    void take_totals();

    World& world_;
    Lines lines_;
    double time_ = 0.0; ///< at the start of the step to come
    physics::DriveState drive_;
};

} // namespace io
