// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The books of momentum of a coupled world: what fluid and grains have, what they are still owed, and which impulses of a
// step explain the change.
#include "io/world.hpp"

namespace io {

/// Of the whole domain, at one time [N s].
struct MomentumTotals {
    core::Vec3 fluid = core::Vec3::Zero();  ///< sum of rho phi u V
    core::Vec3 ledger = core::Vec3::Zero(); ///< sum of L V: owed to the fluid
    core::Vec3 grains = core::Vec3::Zero(); ///< sum of m v
    core::Vec3 owed = core::Vec3::Zero();   ///< to the grains
    [[nodiscard]] core::Vec3 sum() const { return fluid + ledger + grains + owed; }
};

/// Of the last step [N s].
struct MomentumImpulses {
    core::Vec3 drive = core::Vec3::Zero();         ///< on fluid and grains, by volume
    core::Vec3 weight = core::Vec3::Zero();        ///< of the grains, less buoyancy
    core::Vec3 contact = core::Vec3::Zero();       ///< of walls on grains: pairs cancel
    core::Vec3 wall_pressure = core::Vec3::Zero();
    core::Vec3 friction = core::Vec3::Zero();      ///< of walls on the fluid, and what the advection made or lost
    core::Vec3 lift = core::Vec3::Zero();          ///< on grains; the model takes it from nobody
    core::Vec3 given = core::Vec3::Zero();         ///< by the fluid to the grains
    core::Vec3 taken = core::Vec3::Zero();         ///< by the grains, and owed to them
    [[nodiscard]] core::Vec3 outer() const { return drive + weight + contact + wall_pressure + friction + lift; }
};

class MomentumLedger {
public:
    /// Takes the totals of the present state. Collective. @pre world.coupling(), compiled
    explicit MomentumLedger(World& world);

    /// To be called after every step. Collective.
    void update();
    [[nodiscard]] const MomentumTotals& totals() const { return totals_; }
    [[nodiscard]] const MomentumImpulses& impulses() const { return impulses_; }
    /// Change of all momentum in the last step that no impulse explains, over the largest of its terms.
    [[nodiscard]] double defect() const { return defect_; }
    /// |given - taken| over the larger of both, in the last step.
    [[nodiscard]] double exchange_defect() const;

private:
    struct CellSums;
    struct GrainSums;
    [[nodiscard]] CellSums sum_cells(bool with_step) const;
    [[nodiscard]] GrainSums sum_grains(const core::Vec3& drive) const;
    void remember_clock();

    World& world_;
    MomentumTotals totals_;
    MomentumImpulses impulses_;
    double time_ = 0.0; ///< at the start of the step to come
    physics::DriveState drive_;
    double defect_ = 0.0;
};

} // namespace io
